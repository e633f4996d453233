#include "probe/path.h"

#include "probe/extent.h"
#include "probe/spline.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vp::probe
{

namespace
{

bool endsWhereItBegan(const Path& path)
{
	switch (path.kind)
	{
	case PathKind::rotate:
	case PathKind::spin:
		return std::remainder(path.degrees, 360.0) == 0.0;
	case PathKind::revolve:
		return true; // as far as the eye can tell
	case PathKind::keyframes:
		return path.loop;
	case PathKind::translate:
	case PathKind::profile:
		break;
	}
	return false;
}

Frame moved(const Path& path, const Frame& start, const Box& bounds, double done, int frames)
{
	const Vec3 axis = path.axis ? unitVector(*path.axis) : start.normal;
	const Extent extent = extentAlong(bounds, axis, start.origin);
	// Different places, each the middle of a slab; there and back visits those between its ends twice.
	const double places = path.there_and_back && frames > 1 ? 0.5 * frames + 1.0 : frames;
	const double at = -1.0 + (1.0 + 2.0 * done * (places - 1.0)) / places;
	Frame frame = start;
	frame.origin += (extent.middle + at * extent.half) * axis;
	return frame;
}

// Plane `done` of the sweep: the normal turns by 60 degrees about z while the origin moves over the middle 60 % of the
// bounds as seen along it.
Frame profilePose(const Box& bounds, double done)
{
	Frame first;
	first.normal = glm::normalize(Vec3(0.3, 0.5, 0.81));
	const Vec3 normal = turned(first, Vec3(0.0), {0.0, 0.0, 1.0}, -30.0 + 60.0 * done).normal;
	const double reach = extentAlong(bounds, normal, Vec3(0.0)).half;
	return makeFrame(bounds.center() + (-0.6 + 1.2 * done) * reach * normal, normal);
}

Frame keyedPose(const Path& path, double done)
{
	const double first = path.keys.front().at;
	const double length = path.loop ? *path.length : path.keys.back().at - first;
	return splinePose(path.keys, path.loop ? length : 0.0, first + done * length);
}

Frame poseAt(const Path& path, const Probe& probe, const Box& bounds, double done, int frames)
{
	const Frame& start = probe.frame;
	switch (path.kind)
	{
	case PathKind::translate:
		return moved(path, start, bounds, done, frames);
	case PathKind::rotate:
		return turned(start, path.through.value_or(start.origin), path.axis.value_or(start.up), done * path.degrees);
	case PathKind::spin:
		return turned(start, start.origin, start.normal, done * path.degrees);
	case PathKind::revolve:
	{
		const int vanes = path.vanes.value_or(static_cast<int>(std::max<std::size_t>(1, probe.sheets.size())));
		return turned(start, start.origin, start.up, done * 360.0 / vanes);
	}
	case PathKind::profile:
		return profilePose(bounds, done);
	case PathKind::keyframes:
		return keyedPose(path, done);
	}
	return start;
}

} // namespace

double progress(const Path& path, int k, int frames)
{
	if (path.there_and_back)
		return 1.0 - std::abs(1.0 - 2.0 * k / frames);
	if (endsWhereItBegan(path))
		return static_cast<double>(k) / frames;
	return frames == 1 ? 0.0 : static_cast<double>(k) / (frames - 1);
}

std::optional<int> framesOf(const Path& path, double per_second)
{
	const double rate = path.unit == TimeUnit::seconds ? per_second : 1.0;
	double frames = 0.0;
	if (path.length)
		frames = std::round(*path.length * rate);
	else if (path.kind != PathKind::keyframes)
		return std::nullopt;
	else
	{
		const double length = std::round((path.keys.back().at - path.keys.front().at) * rate);
		frames = path.there_and_back ? 2.0 * length : length + 1.0; // both ends, or an end left out
	}
	return static_cast<int>(std::clamp(frames, 1.0, static_cast<double>(kMaxFrames)));
}

std::vector<Frame> poses(const Path& path, const Probe& probe, const Box& bounds, int frames)
{
	assert(frames >= 1 && (path.kind != PathKind::keyframes || path.keys.size() >= 2));
	std::vector<Frame> found;
	for (int k = 0; k < frames; ++k)
		found.push_back(poseAt(path, probe, bounds, progress(path, k, frames), frames));
	return found;
}

} // namespace vp::probe
