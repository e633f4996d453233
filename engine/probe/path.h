#pragma once

#include "probe/probe.h"

#include <optional>
#include <vector>

namespace vp::probe
{

constexpr int kMaxFrames = 1'000'000; // of a film: nine hours at 30 a second
constexpr std::size_t kMaxKeys = 10'000;
constexpr int kProfilePlanes = 60; // of the benchmark's sweep

// The ways a probe is swept. All of them set to_probe, and nothing else.
enum class PathKind
{
	translate, // across the bounds along an axis, by default the probe's normal
	rotate,    // by an angle about an axis, by default the probe's up
	spin,      // by an angle about the probe's normal
	revolve,   // about the probe's up, from each vane to the next: seen as a loop, the whole turn
	profile,   // the benchmark's sweep: tilting planes through the middle of the bounds
	keyframes
};

// Of times in a path: keys' and its length.
enum class TimeUnit
{
	frames,
	seconds
};

struct Key
{
	double at = 0.0; // in the path's unit; rising from key to key
	Frame frame;     // of the probe, in the world

	bool operator==(const Key&) const = default;
};

struct Path
{
	PathKind kind = PathKind::translate;
	std::optional<Vec3> axis;    // translate, rotate: a direction in the world, not zero
	std::optional<Vec3> through; // rotate: a point of the axis; by default the probe's origin
	double degrees = 360.0;      // rotate, spin
	std::optional<int> vanes;    // revolve: 1 or more; by default the probe's sheets
	bool there_and_back = false; // and so a loop
	bool loop = false;           // keyframes: from the last key on to the first, which `length` times
	TimeUnit unit = TimeUnit::frames;
	std::optional<double>
	    length;            // > 0, in the unit, of the whole film; keyframes have theirs from the keys but in a loop
	std::vector<Key> keys; // keyframes: 2 to kMaxKeys

	bool operator==(const Path&) const = default;
};

// How many frames the path says it has, at so many frames a second (which count where the unit is seconds); none where
// it does not say. From 1 to kMaxFrames.
std::optional<int> framesOf(const Path& path, double per_second);

// How much of the way is done in frame `k` of `frames`: 0 to 1.
double progress(const Path& path, int k, int frames);

// The probe's frame in each of `frames` (1 or more) pictures. A path that ends where it began leaves its end out, so
// that the film loops: whole turns, revolve, loops, there and back. Other turns and keyframes have both their ends.
// Translation visits the middles of as many equal slabs of the bounds, so that no frame only touches them.
std::vector<Frame> poses(const Path& path, const Probe& probe, const Box& bounds, int frames);

} // namespace vp::probe
