#include "interact/drag.h"

#include "interact/pick.h"
#include "interact/placing.h"
#include "interact/steps.h"
#include "interact/window_size.h"

#include <algorithm>
#include <cmath>

namespace vp::interact
{

namespace
{

constexpr double kFineFactor = 0.1;
constexpr double kFarthest = 10.0; // in diagonals of the bounds

// The sides that a handle moves.
std::vector<int> sidesOf(const Handle& handle)
{
	if (handle.kind == HandleKind::edge)
		return {handle.part};
	const std::array<int, 2> sides = cornerSides(handle.part);
	return {sides.begin(), sides.end()};
}

double sideOf(const probe::Window& w, int side)
{
	return side == 0 ? w.x0 : side == 1 ? w.x1 : side == 2 ? w.y0 : w.y1;
}

} // namespace

Drag::Drag(const Handle& handle, const glm::dvec2& pixel, const View& view, const probe::Probe& probe,
           const Box& bounds, double ui_scale)
    : handle_(handle), pixel_(pixel), probe_(probe), bounds_(bounds),
      frame_(standOf(probe, handle)), across_{view.camera.right(), view.camera.trueUp()},
      pointer_(makePointer(view, ui_scale))
{
}

Drag::Pointer Drag::makePointer(const View& view, double ui_scale) const
{
	const double farthest = kFarthest * sizeOf(bounds_);
	const Vec3& origin = frame_.origin;
	switch (handle_.kind)
	{
	case HandleKind::move:
		return AxisPointer(view, origin, axisOf(frame_, handle_.axis), pixel_, farthest);
	case HandleKind::turn:
		return RingPointer(view, origin, axisOf(frame_, handle_.axis), pixel_, ui_scale * kRingPixels);
	case HandleKind::center:
		return PlanePointer(view, origin, across_[0], across_[1], pixel_, farthest);
	case HandleKind::sheet:
	{
		// Edge on it may be hit far away, or not at all.
		const auto hit = hitOf(probe::placed(probe_).sheets[handle_.sheet], handle_.sheet, view, pixel_);
		const bool near = hit && glm::length(hit->uv) <= farthest;
		return AxisPointer(view, near ? hit->point : origin, frame_.normal, pixel_, farthest);
	}
	case HandleKind::edge:
	case HandleKind::corner:
		break;
	}
	return makeEdgePointer(view, farthest);
}

// At the place of the side that was taken, or the corner.
Drag::Pointer Drag::makeEdgePointer(const View& view, double farthest) const
{
	const probe::Sheet sheet = probe::placed(probe_).sheets[handle_.sheet];
	const probe::Window& w = *sheet.window;
	const std::vector<int> sides = sidesOf(handle_);
	if (sides.size() == 2)
	{
		const Vec3 corner = pointOn(sheet, {sideOf(w, sides[0]), sideOf(w, sides[1])});
		return PlanePointer(view, corner, frame_.xAxis(), frame_.up, pixel_, farthest);
	}
	// The point of the side that lies under the pixel.
	const int axis = sides[0] / 2;
	glm::dvec2 uv(0.5 * (w.x0 + w.x1), 0.5 * (w.y0 + w.y1));
	uv[axis] = sideOf(w, sides[0]);
	const int along = 1 - axis;
	const double half = 0.5 * (along == 0 ? w.width() : w.height());
	const AxisPointer side(view, pointOn(sheet, uv), axisOf(frame_, along), pixel_, farthest);
	uv[along] += std::clamp(side.under(pixel_), -half, half);
	return AxisPointer(view, pointOn(sheet, uv), axisOf(frame_, axis), pixel_, farthest);
}

double Drag::snapped(double way, const Modifiers& modifiers) const
{
	if (!modifiers.snap)
		return way;
	return rounded(way, (modifiers.fine ? kFineFactor : 1.0) * roundStep(bounds_));
}

probe::Probe Drag::to(const glm::dvec2& pixel, const Modifiers& modifiers) const
{
	if (pixel == pixel_)
		return probe_;
	const double factor = modifiers.fine ? kFineFactor : 1.0;
	const bool own = modifiers.own || handle_.own;
	if (const auto* ring = std::get_if<RingPointer>(&pointer_))
		return turnedBy(factor * ring->moved(pixel), modifiers);
	if (const auto* axis = std::get_if<AxisPointer>(&pointer_))
	{
		const double way = snapped(factor * axis->moved(pixel), modifiers);
		if (handle_.kind == HandleKind::edge)
			return resized(glm::dvec2(way), modifiers);
		return movedBy(way * (handle_.kind == HandleKind::move ? axisOf(frame_, handle_.axis) : frame_.normal), own);
	}
	const glm::dvec2 moved = factor * std::get<PlanePointer>(pointer_).moved(pixel);
	const glm::dvec2 way(snapped(moved.x, modifiers), snapped(moved.y, modifiers));
	if (handle_.kind == HandleKind::corner)
		return resized(way, modifiers);
	return movedBy(way.x * across_[0] + way.y * across_[1], own);
}

probe::Probe Drag::movedBy(const Vec3& way, bool own) const
{
	return moved(probe_, own ? std::optional(handle_.sheet) : std::nullopt, way);
}

probe::Probe Drag::turnedBy(double degrees, const Modifiers& modifiers) const
{
	const bool own = modifiers.own || handle_.own;
	const auto part = own ? std::optional(handle_.sheet) : std::nullopt;
	const Vec3 axis = axisOf(frame_, handle_.axis);
	if (!modifiers.snap)
		return turned(probe_, part, axis, degrees);
	// A world axis goes before a round angle: from an oblique start no round angle leads to one. About the normal
	// itself there is none to be reached.
	if (handle_.axis != 2)
	{
		const probe::Probe free = turned(probe_, part, axis, degrees);
		if (const probe::Probe onto_axis = withNormalSnapped(free, part, kSnapNormalDegrees); onto_axis != free)
			return onto_axis;
	}
	return turned(probe_, part, axis, rounded(degrees, (modifiers.fine ? kFineFactor : 1.0) * kSnapDegrees));
}

probe::Probe Drag::resized(glm::dvec2 way, const Modifiers& modifiers) const
{
	const probe::Window first = *probe_.sheets[handle_.sheet].window;
	probe::Window window = first;
	for (const int side : sidesOf(handle_))
		window = withSideMoved(window, side, way[side / 2], modifiers.both_sides, sizeOf(bounds_));
	return withWindow(probe_, handle_.sheet, window, modifiers.own || handle_.own);
}

} // namespace vp::interact
