#include "interact/placing.h"
#include "base/angle.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vp::interact
{

namespace
{

// In place, so that what is not turned or moved keeps every bit.
probe::Frame& frameIn(probe::Probe& probe, const Part& part)
{
	if (!part)
		return probe.frame;
	assert(*part < probe.sheets.size());
	return probe.sheets[*part];
}

// A direction of the world in the coordinates that a part's frame is given in.
Vec3 inHolder(const probe::Probe& probe, const Part& part, const Vec3& direction)
{
	return part ? probe::toFrame(probe.frame).vector(direction) : direction;
}

} // namespace

probe::Frame frameOf(const probe::Probe& probe, const Part& part)
{
	if (!part)
		return probe.frame;
	assert(*part < probe.sheets.size());
	return probe::placed(probe.sheets[*part], probe.frame);
}

probe::Probe withFrame(const probe::Probe& probe, const Part& part, const probe::Frame& frame)
{
	probe::Probe result = probe;
	// From the origins' difference: far from zero a transform's bottom row would cost digits.
	frameIn(result, part) =
	    probe::makeFrame(part ? inHolder(probe, part, frame.origin - probe.frame.origin) : frame.origin,
	                     inHolder(probe, part, frame.normal), inHolder(probe, part, frame.up));
	return result;
}

probe::Probe moved(const probe::Probe& probe, const Part& part, const Vec3& way)
{
	probe::Probe result = probe;
	frameIn(result, part).origin += inHolder(probe, part, way);
	return result;
}

probe::Probe turned(const probe::Probe& probe, const Part& part, const Vec3& axis, double degrees)
{
	if (degrees == 0.0)
		return probe;
	probe::Probe result = probe;
	probe::Frame& frame = frameIn(result, part);
	frame = probe::turned(frame, frame.origin, inHolder(probe, part, axis), degrees);
	return result;
}

probe::Frame normalTo(const probe::Frame& frame, const Vec3& direction)
{
	const Vec3 normal = probe::unitVector(direction);
	if (normal == frame.normal)
		return frame;
	const Vec3 axis = glm::cross(frame.normal, normal);
	const double sine = glm::length(axis);
	const double cosine = glm::dot(frame.normal, normal);
	// Opposite ones have no axis of their own, and what differs by rounding alone needs none.
	const bool keeps_up = sine == 0.0 || (cosine < 0.0 && sine < 1e-12);
	const Vec3 up =
	    keeps_up ? frame.up : probe::turned(frame, frame.origin, axis, std::atan2(sine, cosine) / kDegree).up;
	return probe::makeFrame(frame.origin, normal, up);
}

probe::Frame snapNormal(const probe::Frame& frame, double most_degrees)
{
	const Vec3 magnitude = glm::abs(frame.normal);
	const int axis = magnitude.x >= magnitude.y && magnitude.x >= magnitude.z ? 0 : magnitude.y >= magnitude.z ? 1 : 2;
	Vec3 nearest(0.0);
	nearest[axis] = std::copysign(1.0, frame.normal[axis]);
	const double off = std::atan2(glm::length(glm::cross(nearest, frame.normal)), magnitude[axis]) / kDegree;
	return off <= most_degrees ? normalTo(frame, nearest) : frame;
}

probe::Probe withNormalSnapped(const probe::Probe& probe, const Part& part, double most_degrees)
{
	const probe::Frame first = frameOf(probe, part);
	const probe::Frame snapped = snapNormal(first, most_degrees);
	return snapped == first ? probe : withFrame(probe, part, snapped);
}

probe::Probe withNormal(const probe::Probe& probe, const Part& part, const Vec3& direction)
{
	return withFrame(probe, part, normalTo(frameOf(probe, part), direction));
}

probe::Probe resetPlace(const probe::Probe& probe, const Box& bounds)
{
	return withFrame(probe, {}, probe::makeFrame(bounds.empty() ? Vec3(0.0) : bounds.center(), Vec3(0.0, 0.0, 1.0)));
}

} // namespace vp::interact
