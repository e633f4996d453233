#pragma once

#include "mesh/mesh_records.h"
#include "probe/sheet.h"
#include "render/scene/camera.h"
#include "render/scene/look.h"
#include "render/scene/outline.h"
#include "render/scene/sheet_contours.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vp::classify
{
struct SheetRecords;
}

namespace vp::render
{

struct SurfacePolygons;

// The array that the sheets show.
struct ValueScale
{
	std::string title; // above the legend: name and component
	double lo = 0.0;   // range of the data
	double hi = 1.0;
	bool has_nan = false;  // the legend gets a swatch for NaN
	bool per_cell = false; // constant in each polygon; contour lines run between polygons
	double log_lo = 0.0;   // low end of a logarithmic scale, above 0; 0: no value is above 0
	bool below = false;    // minus infinity occurs
	bool above = false;    // infinity occurs; lo and hi are finite
	bool empty = false;    // no value is finite, so lo and hi mean nothing
	// The lowest and highest value of the whole array. Nothing: values may lie beyond any range.
	std::optional<std::pair<double, double>> reach{};
};

// x0 < x1 along a sheet's u, y0 < y1 along its v.
struct WindowRect
{
	double x0 = -0.5;
	double x1 = 0.5;
	double y0 = -0.5;
	double y1 = 0.5;
};

// A sheet, and settings of its own in place of the scene's.
struct SheetDrawing
{
	probe::Sheet sheet;                                    // its place: the frame of the records' uv
	std::shared_ptr<const classify::SheetRecords> records; // polygons in device memory; null: an empty sheet
	double opacity = 1.0;                                  // 0 to 1
	std::optional<WindowRect> window{};                    // in the records' uv; nothing outside of it is drawn
	double magnification = 1.0;                            // > 0: uv are enlarged by this factor (fx of the paper)
	bool rim = true;                                       // a line around the window
	std::optional<ValueScale> values{};                    // if it has its own array
	std::optional<ColorMap> colors{};
	std::optional<std::pair<double, double>> range{};
	std::optional<int> lines{}; // about so many contour lines
	// Lines that get labels, the rim of the polygons, and where both are visible, in the records' uv.
	std::vector<LevelLine> contours{};
	std::vector<measure::PlaneLine> rim_lines{};
	std::optional<mesh::UvBounds> bounds{}; // bounds of all its polygons, if others draw a part of them

	Vec3 inWorld(const glm::dvec2& uv) const
	{
		return sheet.origin + magnification * (uv.x * sheet.xAxis() + uv.y * sheet.up);
	}
	glm::dvec2 inRecords(const Vec3& place) const // its uv
	{
		const Vec3 from = (place - sheet.origin) / magnification;
		return {glm::dot(from, sheet.xAxis()), glm::dot(from, sheet.up)};
	}
};

constexpr Color kPlainColor{142, 168, 195}; // without an array

// A surface of any form. It may be closed or bent, and may cross itself. Sheets and surfaces are sorted by depth at
// every pixel. If a sheet lies in a surface, the sheet is in front.
struct Surface
{
	std::shared_ptr<const SurfacePolygons> polygons; // surface_polygons.h; null: nothing
	double opacity = 1.0;                            // 0 to 1; 1 hides what is behind
	Color color = kPlainColor;                       // without values
	bool lit = true;                                 // smooth shading, the same on both sides
	bool thick = false;                              // like glass: more opaque if it is seen from the side
	bool mesh = false;                               // the polygons' edges
	std::optional<ValueScale> values{};              // scale of the array whose values `polygons` has
	std::optional<ColorMap> colors{};
	std::optional<std::pair<double, double>> range{};
	std::optional<int> lines{}; // about so many contour lines
	std::string name{};         // its name in a legend; empty: its number
};

struct Scene
{
	std::vector<SheetDrawing> sheets; // up to shared::kMaxLayers
	std::vector<Surface> surfaces{};  // up to shared::kMaxSurfaces
	std::optional<ValueScale> values; // none: the sheets have one plain color
	std::span<const Segment> outline;
	std::optional<Box> bounds{}; // bounds of the blocks, for numbered axes
	Camera camera;               // fitted to pictureFrame() of the same scene
	bool fitted = true; // the camera keeps the scene away from text; if false, text over the scene gets a ground
	Look look;
};

// Returns the picture, and the part of it without legends, title, caption and axes, for makeCamera(). The scene's
// camera is not used.
Frame pictureFrame(const Scene& scene);

} // namespace vp::render
