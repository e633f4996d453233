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
	center, // freely, parallel to the picture
	sheet,  // the sheet itself, wherever it is taken: along its normal
	edge,   // a side of a sheet's window
	corner  // of a sheet's window
};

// What of a probe can be taken hold of.
struct Handle
{
	HandleKind kind = HandleKind::center;
	int axis = 0;          // move, turn: 0, 1, 2 for x, up and normal of the frame it stands at
	std::size_t sheet = 0; // of the probe; with move, turn and center where `own`
	int part = 0;          // edge: 0 to 3 for the sides at x0, x1, y0, y1; corner: see cornerSides()
	bool own = false;      // stands at the sheet's frame in place of the probe's, and moves that sheet alone

	bool operator==(const Handle&) const = default;
};

// The two sides that meet at a corner, as an edge's parts: at x0 y0, x1 y0, x1 y1, x0 y1.
std::array<int, 2> cornerSides(int corner);

// A handle as it is drawn.
struct HandleShape
{
	Handle handle;
	std::vector<std::vector<Vec3>> lines; // in world coordinates; a closed one tells its first point again at the end
	double alpha = 1.0;                   // 0 to 1: arrows that point at the eye and rings seen edge on fade
	// Whether lines can be taken: not those that have faded, nor a sheet's, of which any place can be (pickSheets).
	bool pickable = true;
};

struct HandleOptions
{
	double ui_scale = 1.0; // > 0; on a display with twice the usual density 2
	// The sheet at whose own frame arrows and rings stand, to move it alone; else they stand at the probe's.
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

// The frame, in the world, that a handle stands at: its sheet's for sheet, edge, corner and what is `own`, else the
// probe's.
probe::Frame standOf(const probe::Probe& probe, const Handle& handle);

// What dragging it does, for tooltips and the steps of a history: "Turn about the normal".
std::string_view wordsOf(const Handle& handle);

// x, up or normal.
Vec3 axisOf(const probe::Frame& frame, int axis);

// Where a point of a placed sheet is drawn, given along its x and y axes.
Vec3 pointOn(const probe::Sheet& placed, const glm::dvec2& uv);

// Of the window of a placed sheet that has one, counter-clockwise from x0 y0: see cornerSides().
std::array<Vec3, 4> windowCorners(const probe::Sheet& placed);

// All handles of a probe's visible sheets: arrows and rings of the same size on screen wherever they stand; none where
// that is behind the eye. A sheet's shape is the outline of its window; without a window it has no line, and is left
// out where its plane misses the bounds.
std::vector<HandleShape> handlesOf(const probe::Probe& probe, const View& view, const Box& bounds,
                                   const HandleOptions& options = {});

} // namespace vp::interact
