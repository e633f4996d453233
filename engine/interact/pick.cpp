#include "interact/pick.h"

#include "interact/steps.h"

#include <algorithm>
#include <limits>

namespace vp::interact
{

namespace
{

int rank(HandleKind kind)
{
	switch (kind)
	{
	case HandleKind::move:
	case HandleKind::corner:
	case HandleKind::center:
		return 0;
	case HandleKind::turn:
		return 1;
	case HandleKind::edge:
	case HandleKind::sheet:
		break;
	}
	return 2;
}

double distance(const glm::dvec2& p, const std::array<glm::dvec2, 2>& segment)
{
	const glm::dvec2 way = segment[1] - segment[0];
	const double square = glm::dot(way, way);
	const double part = square > 0.0 ? std::clamp(glm::dot(p - segment[0], way) / square, 0.0, 1.0) : 0.0;
	return glm::length(p - segment[0] - part * way);
}

double distance(const HandleShape& shape, const View& view, const glm::dvec2& pixel)
{
	double nearest = std::numeric_limits<double>::infinity();
	for (const std::vector<Vec3>& line : shape.lines)
		for (std::size_t i = 1; i < line.size(); ++i)
			if (const auto segment = seenSegment(view, line[i - 1], line[i]))
				nearest = std::min(nearest, distance(pixel, *segment));
	return nearest;
}

bool holds(const Box& box, const Vec3& p)
{
	return glm::all(glm::lessThanEqual(box.lo, p)) && glm::all(glm::lessThanEqual(p, box.hi));
}

bool holds(const probe::Window& window, const glm::dvec2& uv)
{
	return uv.x >= window.x0 && uv.x <= window.x1 && uv.y >= window.y0 && uv.y <= window.y1;
}

} // namespace

std::optional<Handle> pickHandle(std::span<const HandleShape> shapes, const View& view, const glm::dvec2& pixel,
                                 double reach)
{
	const HandleShape* best = nullptr;
	double nearest = 0.0;
	for (const HandleShape& shape : shapes)
	{
		if (!shape.pickable)
			continue;
		const double off = distance(shape, view, pixel);
		if (off > reach)
			continue;
		const int order = best ? rank(shape.handle.kind) - rank(best->handle.kind) : -1;
		if (order < 0 || (order == 0 && off < nearest))
		{
			best = &shape;
			nearest = off;
		}
	}
	return best ? std::optional(best->handle) : std::nullopt;
}

std::optional<SheetHit> hitOf(const probe::Sheet& placed, std::size_t sheet, const View& view, const glm::dvec2& pixel)
{
	const Ray ray = rayOf(view, pixel);
	const std::optional<double> depth = depthOnPlane(ray, placed.origin, placed.normal);
	if (!depth || *depth < view.camera.near)
		return std::nullopt;
	// From the origin before anything else: far from zero a transform's bottom row would cost digits.
	const Vec3 arm = (ray.from - placed.origin) + *depth * ray.along;
	SheetHit hit{sheet, *depth, {glm::dot(arm, placed.xAxis()), glm::dot(arm, placed.up)}, {}, {}, {}};
	hit.point = pointOn(placed, hit.uv);
	hit.content_uv = hit.uv / placed.fx.magnification;
	hit.content = pointOn(probe::content(placed), hit.content_uv);
	return hit;
}

std::vector<SheetHit> pickSheets(const probe::Probe& probe, const View& view, const glm::dvec2& pixel,
                                 const Box& bounds)
{
	const probe::Probe world = probe::placed(probe);
	const Vec3 rim(1e-3 * sizeOf(bounds));
	const Box grown{bounds.lo - rim, bounds.hi + rim};
	std::vector<SheetHit> hits;
	for (std::size_t s = 0; s < world.sheets.size(); ++s)
	{
		const probe::Sheet& sheet = world.sheets[s];
		if (sheet.wishes.hidden)
			continue;
		const std::optional<SheetHit> hit = hitOf(sheet, s, view, pixel);
		if (hit && (sheet.window ? holds(*sheet.window, hit->uv) : holds(grown, hit->content)))
			hits.push_back(*hit);
	}
	std::ranges::stable_sort(hits, {}, &SheetHit::depth);
	return hits;
}

} // namespace vp::interact
