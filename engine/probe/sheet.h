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
// sheet is shown at its origin, the rest magnified about it; pan.z shows what lies so far along the normal.
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

// Centered on the sheet's origin.
inline Window centeredWindow(double width, double height)
{
	return {-0.5 * width, 0.5 * width, -0.5 * height, 0.5 * height};
}

// How a sheet is to be shown where it differs from what holds for all; words as on the command line.
struct SheetWishes
{
	std::optional<double> opacity;                  // 0 to 1
	std::optional<std::string> array;               // "[point:|cell:]NAME"
	std::optional<int> component;                   // from 0, or grid::kMagnitude
	std::optional<std::string> colormap;            // its name
	std::optional<std::pair<double, double>> range; // of the colors, lower < higher
	std::optional<int> lines;                       // contour lines, 0 or more
	bool hidden = false;                            // neither cut nor drawn

	bool operator==(const SheetWishes&) const = default;
};

// A cutting surface with a frame of its own: the plane z = 0 there, whose hot spot is the origin, or another form. The
// frame is given in the probe's coordinates as it is designed, in the world once placed (probe.h).
struct Sheet : Frame
{
	Fx fx;
	std::optional<Window> window; // else the sheet covers the whole slice; through a form it reaches along z
	std::optional<surface::ImplicitSurface> form{}; // none: the plane. No fx then
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
// z = 0 cuts. Without a window, without to_cube.
Transform worldToSheet(const Sheet& sheet);

// (to_probe * to_sheet * to_cube)^-1: fx takes no part, so that its effects remain when the sheet is drawn.
Transform sheetToWorld(const Sheet& sheet);

// World position of what is shown at the sheet's origin.
Vec3 contentHotSpot(const Sheet& sheet);

// The sheet without fx that cuts, clips and seeds what this one shows: its origin is the content's hot spot, its window
// the part of the world that comes to lie in the window. The sheet itself where fx does nothing.
Sheet content(const Sheet& sheet);

// From a point of the cut (of content()) to where it is drawn, worldToSheet then sheetToWorld; the identity where fx
// does nothing. Its inverse gives the true position of what is seen under a pointer.
Transform displayTransform(const Sheet& sheet);

// (u, v) of a point of the cut; the window is [0, 1]^2, both rims included. The sheet must have a window.
glm::dvec2 worldToWindow(const Sheet& sheet, const Vec3& point);

} // namespace vp::probe
