#include "render/passes/sheet_regions.h"

#include "classify/gpu_records.h"
#include "shared/render_types.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <optional>

namespace vp::render
{

namespace
{

// Software works on squares of 64 pixels. A region costs time of its own, so cells are two of them.
constexpr std::uint32_t kCellWidth = 128;
constexpr std::uint32_t kCellHeight = 64;

constexpr double kPad = 2.0; // pixels, for samples beside the middle and for rounding

using Corners = std::array<glm::dvec2, 4>;
using SheetMask = std::uint32_t; // a bit a sheet
static_assert(shared::kMaxLayers <= 32);

// Returns the bounds of the area that a sheet shows, in its records' uv, or nothing if they are unknown.
std::optional<mesh::UvBounds> shownBounds(const SheetDrawing& drawing)
{
	std::optional<mesh::UvBounds> bounds = drawing.bounds ? drawing.bounds : drawing.records->bounds;
	if (const auto& window = drawing.window)
	{
		const mesh::UvBounds all = bounds.value_or(mesh::UvBounds{glm::dvec2(-1e300), glm::dvec2(1e300)});
		bounds = mesh::UvBounds{glm::max(all.lo, {window->x0, window->y0}), glm::min(all.hi, {window->x1, window->y1})};
	}
	return bounds;
}

// The corners of what a sheet shows, in pixels of the part; none: it may be anywhere.
std::optional<Corners> seenCorners(const SheetDrawing& drawing, const Camera& camera, const PicturePart& part)
{
	const auto bounds = shownBounds(drawing);
	if (!bounds)
		return std::nullopt;
	const Frame frame{static_cast<double>(part.picture.width), static_cast<double>(part.picture.height), {}, {}, {}};
	const glm::dvec2 lo = bounds->lo;
	const glm::dvec2 hi = bounds->hi;
	Corners corners{lo, {hi.x, lo.y}, hi, {lo.x, hi.y}};
	for (glm::dvec2& corner : corners)
	{
		const Vec3 at = drawing.inWorld(corner);
		if (!(glm::dot(at - camera.position, camera.forward()) > camera.near))
			return std::nullopt;
		corner = camera.project(at, frame) - glm::dvec2(0.0, part.first_row);
	}
	return corners;
}

// Returns true if all corners lie beyond a line through a cell's padded rectangle, seen from along `normal`.
bool isApart(const Corners& corners, const glm::dvec2& normal, const glm::dvec2& middle, const glm::dvec2& half)
{
	const double reach = glm::dot(glm::abs(normal), half + kPad);
	double least = 1e300;
	double most = -1e300;
	for (const glm::dvec2& corner : corners)
	{
		const double distance = glm::dot(normal, corner - middle);
		least = std::min(least, distance);
		most = std::max(most, distance);
	}
	return least > reach || most < -reach;
}

// Two convex outlines are apart if a line along one of their sides parts them.
bool mayMeet(const Corners& corners, const glm::dvec2& middle, const glm::dvec2& half)
{
	if (isApart(corners, {1.0, 0.0}, middle, half) || isApart(corners, {0.0, 1.0}, middle, half))
		return false;
	for (std::size_t i = 0; i < corners.size(); ++i)
	{
		const glm::dvec2 side = corners[(i + 1) % corners.size()] - corners[i];
		if (isApart(corners, {-side.y, side.x}, middle, half))
			return false;
	}
	return true;
}

struct Cells
{
	std::uint32_t across;
	std::uint32_t down;
	std::vector<SheetMask> masks;
};

Cells maskedCells(const Scene& scene, const PicturePart& part)
{
	const auto over = [](std::uint32_t pixels, std::uint32_t side) { return (pixels + side - 1) / side; };
	Cells cells{over(part.extent.width, kCellWidth), over(part.extent.height, kCellHeight), {}};
	cells.masks.assign(std::size_t(cells.across) * cells.down, 0);
	const glm::dvec2 half = 0.5 * glm::dvec2(kCellWidth, kCellHeight);
	for (std::size_t s = 0; s < scene.sheets.size(); ++s)
	{
		const SheetDrawing& drawing = scene.sheets[s];
		if (!drawing.bounds && (!drawing.records || drawing.records->pages.empty()))
			continue;
		const auto corners = seenCorners(drawing, scene.camera, part);
		for (std::uint32_t y = 0; y < cells.down; ++y)
			for (std::uint32_t x = 0; x < cells.across; ++x)
			{
				const glm::dvec2 middle = glm::dvec2(x * kCellWidth, y * kCellHeight) + half;
				if (!corners || mayMeet(*corners, middle, half))
					cells.masks[std::size_t(y) * cells.across + x] |= SheetMask(1) << s;
			}
	}
	return cells;
}

SheetRegion regionOf(SheetMask mask, const VkRect2D& pixels)
{
	SheetRegion region{pixels, {}};
	for (std::uint32_t s = 0; s < shared::kMaxLayers; ++s)
		if (mask >> s & 1u)
			region.sheets.push_back(s);
	return region;
}

} // namespace

std::vector<SheetRegion> sheetRegions(const Scene& scene, const PicturePart& part)
{
	const Cells cells = maskedCells(scene, part);
	std::vector<bool> taken(cells.masks.size());
	std::vector<SheetRegion> regions;
	for (std::uint32_t y = 0; y < cells.down; ++y)
		for (std::uint32_t x = 0; x < cells.across; ++x)
		{
			const std::size_t first = std::size_t(y) * cells.across + x;
			if (taken[first])
				continue;
			const SheetMask mask = cells.masks[first];
			const auto isFree = [&](std::size_t i) { return !taken[i] && cells.masks[i] == mask; };
			std::uint32_t right = x + 1;
			while (right < cells.across && isFree(first + right - x))
				++right;
			std::uint32_t below = y + 1;
			const auto isFreeRow = [&](std::uint32_t row)
			{
				for (std::uint32_t i = x; i < right; ++i)
					if (!isFree(std::size_t(row) * cells.across + i))
						return false;
				return true;
			};
			while (below < cells.down && isFreeRow(below))
				++below;
			for (std::uint32_t row = y; row < below; ++row)
				std::fill_n(taken.begin() + static_cast<std::ptrdiff_t>(std::size_t(row) * cells.across + x), right - x,
				            true);
			const std::uint32_t from_x = x * kCellWidth;
			const std::uint32_t from_y = y * kCellHeight;
			regions.push_back(regionOf(mask, {{static_cast<std::int32_t>(from_x), static_cast<std::int32_t>(from_y)},
			                                  {std::min(right * kCellWidth, part.extent.width) - from_x,
			                                   std::min(below * kCellHeight, part.extent.height) - from_y}}));
		}
	return regions;
}

} // namespace vp::render
