#pragma once

#include "probe/probe.h"

#include <optional>
#include <vector>

namespace vp::probe
{

constexpr int kMaxFrames = 1'000'000; // frames of a film: nine hours at 30 per second
constexpr std::size_t kMaxKeys = 10'000;
constexpr int kProfilePlanes = 60; // planes of the benchmark's sweep

// The ways to sweep a probe. All of them set to_probe and nothing else.
enum class PathKind
{
	translate, // across the bounds along an axis, by default the probe's normal
	rotate,    // by an angle about an axis, by default the probe's up
	spin,      // by an angle about the probe's normal
	revolve,   // about the probe's up, from each vane to the next; as a loop it looks like a whole turn
	profile,   // the benchmark's sweep: tilting planes through the middle of the bounds
	keyframes
};

// The unit of times in a path: those of keys, and its length.
enum class TimeUnit
{
	frames,
	seconds
};

struct Key
{
	double at = 0.0; // in the path's unit; rising from key to key
	Frame frame;     // frame of the probe in the world

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
	bool loop = false;           // keyframes: goes on from the last key to the first, in the time `length`
	TimeUnit unit = TimeUnit::frames;
	std::optional<double>
	    length;            // > 0, in the unit, of the whole film; keyframes take it from the keys, except in a loop
	std::vector<Key> keys; // keyframes: 2 to kMaxKeys

	bool operator==(const Path&) const = default;
};

// Returns the number of frames of the path, 1 to kMaxFrames, or nothing if it has no length. The frames a second matter
// if the unit is seconds.
std::optional<int> framesOf(const Path& path, double per_second);

// Returns the part of the way that is done in frame `k` of `frames`: 0 to 1.
double progress(const Path& path, int k, int frames);

// Returns the probe's frame in each of `frames` (1 or more) pictures. A path that ends where it began leaves out its
// end, so that the film loops: whole turns, revolve, loops, there and back. Other turns and keyframes include both
// ends. Translation visits the middles of equal slabs of the bounds, so that no picture only touches the bounds.
std::vector<Frame> poses(const Path& path, const Probe& probe, const Box& bounds, int frames);

} // namespace vp::probe
