#include "interact/handles.h"

#include "probe/presets.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace vp::interact
{

namespace
{

constexpr int kRingSegments = 64;
constexpr double kArrowBegin = 14.0; // pixels from the center, which has a handle of its own there
constexpr double kHeadLength = 14.0;
constexpr double kHeadHalfWidth = 5.0;
constexpr double kCenterPixels = 7.0;
constexpr int kCenterSegments = 16;

// Full where it is twice as far from its limit as need be.
double fade(double sine, double limit)
{
	return std::clamp((sine - limit) / limit, 0.0, 1.0);
}

std::vector<Vec3> circle(const Vec3& center, const Vec3& x, const Vec3& y, double radius, int segments)
{
	std::vector<Vec3> points;
	for (int i = 0; i < segments; ++i)
	{
		const double angle = 2.0 * std::numbers::pi * i / segments;
		points.push_back(center + radius * (std::cos(angle) * x + std::sin(angle) * y));
	}
	points.push_back(points.front());
	return points;
}

// Arrows, rings and center at one frame.
class Stand
{
public:
	Stand(const probe::Frame& frame, const View& view, const HandleOptions& options)
	    : frame_(frame), view_(view), options_(options), sight_(frame.origin - view.camera.position),
	      pixel_(options.ui_scale / pixelsPerLength(view, depthOf(view, frame.origin)))
	{
	}

	HandleShape arrow(int axis) const
	{
		const Vec3 along = axisOf(frame_, axis);
		const Vec3 beside = glm::cross(along, sight_);
		const double sine = glm::length(beside) / glm::length(sight_);
		HandleShape shape = faded({HandleKind::move, axis}, sine, kAtEye);
		const Vec3 tip = at(along, kArrowPixels);
		const Vec3 barb = sine > 0.0 ? pixel_ * kHeadHalfWidth * glm::normalize(beside) : Vec3(0.0);
		const Vec3 back = at(along, kArrowPixels - kHeadLength);
		shape.lines = {{at(along, kArrowBegin), tip}, {back + barb, tip, back - barb}};
		return shape;
	}

	HandleShape ring(int axis) const
	{
		const double sine = std::abs(glm::dot(axisOf(frame_, axis), sight_)) / glm::length(sight_);
		HandleShape shape = faded({HandleKind::turn, axis}, sine, kEdgeOn);
		shape.lines = {circle(frame_.origin, axisOf(frame_, (axis + 1) % 3), axisOf(frame_, (axis + 2) % 3),
		                      pixel_ * kRingPixels, kRingSegments)};
		return shape;
	}

	HandleShape center() const
	{
		HandleShape shape = faded({HandleKind::center}, 1.0, 0.5);
		shape.lines = {circle(frame_.origin, view_.camera.right(), view_.camera.trueUp(), pixel_ * kCenterPixels,
		                      kCenterSegments)};
		return shape;
	}

private:
	Vec3 at(const Vec3& along, double pixels) const { return frame_.origin + pixel_ * pixels * along; }

	HandleShape faded(Handle handle, double sine, double limit) const
	{
		if (options_.own)
		{
			handle.own = true;
			handle.sheet = *options_.own;
		}
		const double alpha = fade(sine, limit);
		return {handle, {}, alpha, alpha > 0.0};
	}

	const probe::Frame& frame_;
	const View& view_;
	const HandleOptions& options_;
	Vec3 sight_;
	double pixel_; // the length of one there
};

void addStand(const probe::Frame& frame, const View& view, const HandleOptions& options,
              std::vector<HandleShape>& shapes)
{
	if (depthOf(view, frame.origin) < view.camera.near)
		return;
	const Stand stand(frame, view, options);
	shapes.push_back(stand.center());
	for (int axis = 0; axis < 3; ++axis)
		shapes.push_back(stand.arrow(axis));
	for (int axis = 0; axis < 3; ++axis)
		shapes.push_back(stand.ring(axis));
}

// A corner's mark: the last pixels of both sides that meet there, no longer than a quarter of each.
HandleShape cornerShape(const probe::Sheet& sheet, std::size_t s, int corner, const std::array<Vec3, 4>& corners,
                        const View& view, double ui_scale)
{
	constexpr double kPixels = 12.0;
	const Vec3& at = corners[corner];
	const double depth = depthOf(view, at);
	const double length = depth > 0.0 ? kPixels * ui_scale / pixelsPerLength(view, depth) : 0.0;
	const auto towards = [&](int other, double side)
	{ return at + std::min(0.25, length / side) * (corners[other] - at); };
	const double width = sheet.window->width();
	const double height = sheet.window->height();
	const bool along_x = corner % 2 == 0; // the next corner lies across
	const Vec3 next = towards((corner + 1) % 4, along_x ? width : height);
	const Vec3 last = towards((corner + 3) % 4, along_x ? height : width);
	return {{HandleKind::corner, 0, s, corner}, {{next, at, last}}, 1.0, depth >= view.camera.near};
}

// A window that reaches around all data, as a paddlewheel's own does, ends where the data end: its rim lies around what
// the plane may cut of them. Its sides out there cannot be dragged.
std::optional<probe::Window> windowInData(const probe::Sheet& sheet, const Box& bounds)
{
	if (!probe::reachesAround(*sheet.window, bounds))
		return sheet.window;
	const auto cornerAt = [&](int i)
	{
		return Vec3(i & 1 ? bounds.hi.x : bounds.lo.x, i & 2 ? bounds.hi.y : bounds.lo.y,
		            i & 4 ? bounds.hi.z : bounds.lo.z);
	};
	glm::dvec2 lo(std::numeric_limits<double>::max());
	glm::dvec2 hi(-std::numeric_limits<double>::max());
	for (int axis = 0; axis < 3; ++axis)
		for (int i = 0; i < 8; ++i)
		{
			if (i & 1 << axis)
				continue;
			const Vec3 a = cornerAt(i);
			const Vec3 b = cornerAt(i | 1 << axis);
			const double from = glm::dot(a - sheet.origin, sheet.normal);
			const double to = glm::dot(b - sheet.origin, sheet.normal);
			if ((from > 0.0) == (to > 0.0) && from != 0.0)
				continue;
			const Vec3 at = a + (from == to ? 0.0 : from / (from - to)) * (b - a) - sheet.origin;
			const glm::dvec2 uv(glm::dot(at, sheet.xAxis()), glm::dot(at, sheet.up));
			lo = glm::min(lo, uv);
			hi = glm::max(hi, uv);
		}
	const probe::Window& window = *sheet.window;
	const probe::Window inside{std::max(window.x0, lo.x), std::min(window.x1, hi.x), std::max(window.y0, lo.y),
	                           std::min(window.y1, hi.y)};
	return inside.x0 < inside.x1 && inside.y0 < inside.y1 ? std::optional(inside) : std::nullopt;
}

void addWindow(const probe::Sheet& sheet, std::size_t s, const View& view, const Box& bounds, double ui_scale,
               std::vector<HandleShape>& shapes)
{
	const std::optional<probe::Window> in_data = windowInData(sheet, bounds);
	if (!in_data)
		return;
	if (*in_data != *sheet.window)
	{
		probe::Sheet shown = sheet;
		shown.window = in_data;
		const std::array<Vec3, 4> rim = windowCorners(shown);
		shapes.push_back({{HandleKind::sheet, 2, s}, {{rim[0], rim[1], rim[2], rim[3], rim[0]}}, 1.0, false});
		return;
	}
	const std::array<Vec3, 4> corner = windowCorners(sheet);
	shapes.push_back(
	    {{HandleKind::sheet, 2, s}, {{corner[0], corner[1], corner[2], corner[3], corner[0]}}, 1.0, false});
	constexpr std::array<std::array<int, 2>, 4> kEnds{{{0, 3}, {1, 2}, {0, 1}, {3, 2}}};
	for (int side = 0; side < 4; ++side)
		shapes.push_back(
		    {{HandleKind::edge, 0, s, side}, {{corner[kEnds[side][0]], corner[kEnds[side][1]]}}, 1.0, true});
	for (int i = 0; i < 4; ++i)
		shapes.push_back(cornerShape(sheet, s, i, corner, view, ui_scale));
}

} // namespace

std::array<int, 2> cornerSides(int corner)
{
	return {corner == 0 || corner == 3 ? 0 : 1, corner < 2 ? 2 : 3};
}

probe::Frame standOf(const probe::Probe& probe, const Handle& handle)
{
	const bool at_probe =
	    handle.kind == HandleKind::move || handle.kind == HandleKind::turn || handle.kind == HandleKind::center;
	if (at_probe && !handle.own)
		return probe.frame;
	assert(handle.sheet < probe.sheets.size());
	return probe::placed(probe.sheets[handle.sheet], probe.frame);
}

std::string_view wordsOf(const Handle& handle)
{
	constexpr std::array<std::string_view, 3> kMoves{"Move along the x axis", "Move along up", "Move along the normal"};
	constexpr std::array<std::string_view, 3> kTurns{"Turn about the x axis", "Turn about up", "Turn about the normal"};
	switch (handle.kind)
	{
	case HandleKind::move:
		return kMoves[handle.axis];
	case HandleKind::turn:
		return kTurns[handle.axis];
	case HandleKind::center:
		return "Move parallel to the picture";
	case HandleKind::sheet:
		return "Push along the normal";
	case HandleKind::edge:
	case HandleKind::corner:
		break;
	}
	return "Resize the window";
}

Vec3 axisOf(const probe::Frame& frame, int axis)
{
	return axis == 0 ? frame.xAxis() : axis == 1 ? frame.up : frame.normal;
}

Vec3 pointOn(const probe::Sheet& placed, const glm::dvec2& uv)
{
	return placed.origin + (uv.x * placed.xAxis() + uv.y * placed.up);
}

std::array<Vec3, 4> windowCorners(const probe::Sheet& placed)
{
	const probe::Window& w = *placed.window;
	return {pointOn(placed, {w.x0, w.y0}), pointOn(placed, {w.x1, w.y0}), pointOn(placed, {w.x1, w.y1}),
	        pointOn(placed, {w.x0, w.y1})};
}

std::vector<HandleShape> handlesOf(const probe::Probe& probe, const View& view, const Box& bounds,
                                   const HandleOptions& options)
{
	std::vector<HandleShape> shapes;
	const probe::Probe world = probe::placed(probe);
	const auto visible = [](const probe::Sheet& sheet) { return !sheet.wishes.hidden; };
	if (options.own ? visible(world.sheets[*options.own]) : std::ranges::any_of(world.sheets, visible))
		addStand(options.own ? world.sheets[*options.own] : probe.frame, view, options, shapes);
	for (std::size_t s = 0; s < world.sheets.size(); ++s)
	{
		const probe::Sheet& sheet = world.sheets[s];
		if (sheet.wishes.hidden)
			continue;
		if (sheet.window)
			addWindow(sheet, s, view, bounds, options.ui_scale, shapes);
		else if (probe::content(sheet).plane().meets(bounds))
			shapes.push_back({{HandleKind::sheet, 2, s}, {}, 1.0, false});
	}
	return shapes;
}

} // namespace vp::interact
