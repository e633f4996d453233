#pragma once

#include "interact/view.h"
#include "probe/probe.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace vp::interact
{

enum class HandleKind
{
	move,   // an arrow: along the axis
	turn,   // a ring: about the axis
	center, // moves freely, parallel to the picture
	sheet,  // the sheet itself, at any place: moves along its normal
	edge,   // a side of a sheet's window
	corner  // a corner of a sheet's window
};

// The parts of a probe that the user can drag.
struct Handle
{
	HandleKind kind = HandleKind::center;
	int axis = 0;          // move, turn: 0, 1, 2 for x, up and normal of the frame it stands at
	std::size_t sheet = 0; // sheet of the probe; used by move, turn and center only if `own`
	int part = 0;          // edge: 0 to 3 for the sides at x0, x1, y0, y1; corner: see cornerSides()
	bool own = false;      // the handle is at the sheet's frame, and moves only this sheet

	bool operator==(const Handle&) const = default;
};

// The two sides that meet at a corner, as an edge's parts: at x0 y0, x1 y0, x1 y1, x0 y1.
std::array<int, 2> cornerSides(int corner);

// A handle for drawing.
struct HandleShape
{
	Handle handle;
	std::vector<std::vector<Vec3>> lines; // in world coordinates; a closed line repeats its first point at the end
	double alpha = 1.0;                   // 0 to 1: arrows that point at the eye and rings seen edge on fade
	// Returns true if its lines can be picked. Faded lines cannot, and a sheet is picked at any place of it
	// (pickSheets).
	bool pickable = true;
};

struct HandleOptions
{
	double ui_scale = 1.0; // > 0; 2 on a display with twice the usual density
	// The sheet whose frame has the arrows and rings, to move only this sheet. Without it they are at the probe's
	// frame.
	std::optional<std::size_t> own;
};

// Sizes on screen at ui_scale 1.
constexpr double kArrowPixels = 90.0;
constexpr double kRingPixels = 66.0;

// Below this sine of the angle between an axis and the line of sight (14 degrees) the axis points at the eye: a pixel
// would mean four times its length, and more with every degree. A plane's normal is at right angles to the line of
// sight as closely as that where it is seen edge on; 6 degrees are enough there, since it keeps one good direction.
constexpr double kAtEye = 0.25;
constexpr double kEdgeOn = 0.1;

// Returns the frame of a handle in the world: that of its sheet for sheet, edge, corner and `own`, else that of the
// probe.
probe::Frame standOf(const probe::Probe& probe, const Handle& handle);

// Returns what dragging does, for tooltips and the history: "Turn about the normal".
std::string_view wordsOf(const Handle& handle);

// x, up or normal.
Vec3 axisOf(const probe::Frame& frame, int axis);

// Returns the drawn place of a point of a placed sheet, which is given along its x and y axes.
Vec3 pointOn(const probe::Sheet& placed, const glm::dvec2& uv);

// Returns the corners of the window of a placed sheet, counter-clockwise from x0 y0, see cornerSides(). The sheet must
// have a window.
std::array<Vec3, 4> windowCorners(const probe::Sheet& placed);

// Returns all handles of a probe's visible sheets. Arrows and rings have the same size on screen everywhere, and are
// left out behind the eye. The shape of a sheet is the outline of its window. A sheet without a window has no line, and
// is left out if its plane misses the bounds.
std::vector<HandleShape> handlesOf(const probe::Probe& probe, const View& view, const Box& bounds,
                                   const HandleOptions& options = {});

} // namespace vp::interact
