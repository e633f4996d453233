#pragma once

#include "probe/transform.h"
#include "surface/implicit_surface.h"
#include "surface/plane.h"

#include <optional>
#include <string>
#include <utility>

namespace vp::probe
{

// The special effects of a sheet, fx: x' = magnification (x - pan) in the sheet's coordinates. The point `pan` of the
// sheet is shown at its origin, and the rest is magnified about it. pan.z shows what lies at that distance along the
// normal.
struct Fx
{
	double magnification = 1.0; // > 0
	Vec3 pan{0.0};

	bool operator==(const Fx&) const = default;
};

// The rectangle [x0, x1] x [y0, y1] of a sheet, in its coordinates after fx: what to_cube maps to the unit square.
struct Window
{
	double x0 = -0.5; // < x1
	double x1 = 0.5;
	double y0 = -0.5; // < y1
	double y1 = 0.5;

	double width() const { return x1 - x0; }
	double height() const { return y1 - y0; }

	bool operator==(const Window&) const = default;
};

// Returns a window that is centered on the sheet's origin.
inline Window centeredWindow(double width, double height)
{
	return {-0.5 * width, 0.5 * width, -0.5 * height, 0.5 * height};
}

// The settings of one sheet that replace those for all. Words are the same as on the command line.
struct SheetWishes
{
	std::optional<double> opacity;                  // 0 to 1
	std::optional<std::string> array;               // "[point:|cell:]NAME"
	std::optional<int> component;                   // from 0, or grid::kMagnitude
	std::optional<std::string> colormap;            // its name
	std::optional<std::pair<double, double>> range; // range of the colors, lower < higher
	std::optional<int> lines;                       // contour lines, 0 or more
	bool hidden = false;                            // neither cut nor drawn

	bool operator==(const SheetWishes&) const = default;
};

// A cutting surface with its own frame: the plane z = 0 of the frame, whose hot spot is the origin, or another form.
// The frame is given in the probe's coordinates, and in the world after placing (probe.h).
struct Sheet : Frame
{
	Fx fx;
	std::optional<Window> window; // without one the sheet covers the whole slice; through a form it extends along z
	std::optional<surface::ImplicitSurface> form{}; // nothing: the plane; with a form there is no fx
	SheetWishes wishes{};

	surface::Plane plane() const { return {origin, normal}; } // where it is drawn; fx may cut another: content()

	surface::Axes axes() const { return {origin, xAxis(), up, normal}; }

	bool operator==(const Sheet&) const = default;
};

// See makeFrame.
Sheet makeSheet(const Vec3& origin, const Vec3& normal, const Vec3& up = {0.0, 1.0, 0.0});

Transform fxTransform(const Fx& fx);

// z is not scaled.
Transform toCube(const Window& window);

// The functions below are for a sheet placed in the world.

// The paper's to_probe * to_sheet * fx * to_cube: world coordinates to the window's, where the unit square clips and
// z = 0 cuts. Without a window there is no to_cube.
Transform worldToSheet(const Sheet& sheet);

// (to_probe * to_sheet * to_cube)^-1: fx takes no part, so that its effects remain when the sheet is drawn.
Transform sheetToWorld(const Sheet& sheet);

// Returns the world position that is shown at the sheet's origin.
Vec3 contentHotSpot(const Sheet& sheet);

// Returns the sheet without fx that cuts, clips and seeds what this one shows. Its origin is the hot spot of the
// content, and its window is the part of the world that appears in the window. If fx does nothing, it is the sheet
// itself.
Sheet content(const Sheet& sheet);

// Returns the map from a point of the cut (of content()) to the place where it is drawn: worldToSheet, then
// sheetToWorld. It is the identity if fx does nothing. Its inverse maps the place under a pointer to the true position.
Transform displayTransform(const Sheet& sheet);

// Returns (u, v) of a point of the cut. The window is [0, 1]^2, including both rims. The sheet must have a window.
glm::dvec2 worldToWindow(const Sheet& sheet, const Vec3& point);

} // namespace vp::probe
