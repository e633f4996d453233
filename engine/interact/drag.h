#pragma once

#include "interact/handles.h"
#include "interact/pointers.h"

#include <variant>

namespace vp::interact
{

// The keys held during a drag.
struct Modifiers
{
	bool fine = false;       // a tenth
	bool snap = false;       // round steps, see roundStep(); 15 degrees; normals onto the world's axes
	bool both_sides = false; // edge, corner: the opposite side goes the other way
	bool own = false;        // one sheet alone: the handle's; else sheets move, and equal windows change, as one

	bool operator==(const Modifiers&) const = default;
};

constexpr double kSnapDegrees = 15.0;
constexpr double kSnapNormalDegrees = 4.0; // so near to a world axis, or its negative, a turned normal becomes it

// A probe taken hold of. Where it goes is always reckoned from where it was taken, so nothing drifts, and the first
// pixel gives the first probe back to the last bit. Windows stay within 1e-6 to 100 of the bounds' diagonal, or what
// they were; nothing goes farther than 10 of it.
class Drag
{
public:
	// handle: one of the probe's. pixel: where it was taken. view: as it is then; it does not change meanwhile.
	Drag(const Handle& handle, const glm::dvec2& pixel, const View& view, const probe::Probe& probe, const Box& bounds,
	     double ui_scale = 1.0);

	probe::Probe to(const glm::dvec2& pixel, const Modifiers& modifiers = {}) const;

	const Handle& handle() const { return handle_; }
	const probe::Probe& start() const { return probe_; }

private:
	using Pointer = std::variant<AxisPointer, RingPointer, PlanePointer>;

	Pointer makePointer(const View& view, double ui_scale) const;
	Pointer makeEdgePointer(const View& view, double farthest) const;
	probe::Probe movedBy(const Vec3& way, bool own) const; // in the world
	probe::Probe turnedBy(double degrees, const Modifiers& modifiers) const;
	probe::Probe resized(glm::dvec2 way, const Modifiers& modifiers) const;
	double snapped(double way, const Modifiers& modifiers) const;

	Handle handle_;
	glm::dvec2 pixel_;
	probe::Probe probe_;
	Box bounds_;
	probe::Frame frame_;         // that the handle stands at
	std::array<Vec3, 2> across_; // center: the picture's axes
	Pointer pointer_;
};

} // namespace vp::interact
