#pragma once

#include "interact/handles.h"

#include <optional>
#include <span>
#include <vector>

namespace vp::interact
{

// The handle under a pixel: of those with a line within `reach` pixels arrows, corners and center go before rings,
// rings before edges; then the nearest on screen.
std::optional<Handle> pickHandle(std::span<const HandleShape> shapes, const View& view, const glm::dvec2& pixel,
                                 double reach = 6.0);

// Where a ray meets a sheet.
struct SheetHit
{
	std::size_t sheet;
	double depth;          // along the camera's forward()
	glm::dvec2 uv;         // along the sheet's x and y axes from its origin, as drawn: the window's coordinates
	Vec3 point;            // in the world, as drawn
	glm::dvec2 content_uv; // the same of what is shown there, in probe::content()'s frame
	Vec3 content;          // true position of what is shown there
};

// The visible sheets under a pixel, the nearest first: within their windows; without a window where what is shown lies
// in the bounds, grown by a thousandth of their diagonal. Whether the grid is cut there, a SheetLookup
// (measure/sheet_lookup.h) knows.
std::vector<SheetHit> pickSheets(const probe::Probe& probe, const View& view, const glm::dvec2& pixel,
                                 const Box& bounds);

// Returns where the plane of a placed sheet lies under a pixel, also outside its window. Returns nothing if that is not
// in front of the eye.
std::optional<SheetHit> hitOf(const probe::Sheet& placed, std::size_t sheet, const View& view, const glm::dvec2& pixel);

} // namespace vp::interact
