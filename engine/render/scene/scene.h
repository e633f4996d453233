#pragma once

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
	double lo = 0.0;   // of the data
	double hi = 1.0;
	bool has_nan = false;  // puts a swatch into the legend
	bool per_cell = false; // constant in each polygon: contour lines go between polygons
	double log_lo = 0.0;   // low end of a logarithmic scale, > 0; 0: no value is above 0
	bool below = false;    // there is minus infinity
	bool above = false;    // and infinity; lo and hi are finite
	bool empty = false;    // no value is finite: lo and hi say nothing
};

// x0 < x1 along a sheet's u, y0 < y1 along its v.
struct WindowRect
{
	double x0 = -0.5;
	double x1 = 0.5;
	double y0 = -0.5;
	double y1 = 0.5;
};

// A sheet, and where it is to look other than the scene says.
struct SheetDrawing
{
	probe::Sheet sheet;                                    // where it is drawn: the frame of the records' uv
	std::shared_ptr<const classify::SheetRecords> records; // polygons in device memory; null: an empty sheet
	double opacity = 1.0;                                  // 0 to 1
	std::optional<WindowRect> window{};                    // in the records' uv; nothing outside of it is drawn
	double magnification = 1.0;                            // > 0: uv are drawn so many times larger (fx of the paper)
	bool rim = true;                                       // a line around the window
	std::optional<ValueScale> values{};                    // of an array of its own
	std::optional<ColorMap> colors{};
	std::optional<std::pair<double, double>> range{};
	std::optional<int> lines{}; // about so many contour lines
	// Lines that are to bear their values, and what bounds the polygons; where they are seen, in the records' uv.
	std::vector<LevelLine> contours{};
	std::vector<measure::PlaneLine> rim_lines{};

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

constexpr Color kPlainColor{142, 168, 195}; // where there is no array to show

// A surface of any form. It may be closed, bent and cut itself; sheets and surfaces are drawn in their order at every
// pixel, and where a sheet lies in a surface the sheet is in front.
struct Surface
{
	std::shared_ptr<const SurfacePolygons> polygons; // surface_polygons.h; null: nothing
	double opacity = 1.0;                            // 0 to 1; 1 hides what is behind
	Color color = kPlainColor;                       // where there are no values
	bool lit = true;                                 // shaded smoothly; both sides alike
	bool thick = false;                              // like glass: the more opaque the more it is seen from the side
	bool mesh = false;                               // the polygons' edges
	std::optional<ValueScale> values{};              // of the array that `polygons` has values of
	std::optional<ColorMap> colors{};
	std::optional<std::pair<double, double>> range{};
	std::optional<int> lines{}; // about so many contour lines
	std::string name{};         // what a legend calls it where it calls it anything; else by its number
};

struct Scene
{
	std::vector<SheetDrawing> sheets; // up to shared::kMaxLayers
	std::vector<Surface> surfaces{};  // up to shared::kMaxSurfaces
	std::optional<ValueScale> values; // none: the sheets have one plain color
	std::span<const Segment> outline;
	std::optional<Box> bounds{}; // of the blocks, for numbered axes
	Camera camera;               // made for pictureFrame() of the same scene
	bool fitted = true;          // the camera keeps the scene off what is written; else words over it get a ground
	Look look;
};

// The picture and the part of it that legends, title, caption and axes leave: for makeCamera(). The scene's camera
// takes no part.
Frame pictureFrame(const Scene& scene);

} // namespace vp::render
