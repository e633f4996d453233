#pragma once

#include "probe/probe.h"

#include <optional>
#include <span>
#include <vector>

namespace vp::probe
{

// The built-in probes. `frame` is the place of the probe in the world.

// W along a sheet's x axis, H along its y axis, both > 0 and in the grid's units.
struct WindowSize
{
	double width;
	double height;

	bool operator==(const WindowSize&) const = default;
};

// One sheet, the plane z = 0 of the probe: the paper's magnifying glass. A window is centered.
Probe single(const Frame& frame, const std::optional<WindowSize>& size = {});

// Three sheets at right angles: normal to the probe's x axis, y axis (up) and z axis (normal), in this order. Their
// up is that of the probe; the sheet normal to it has x as its up. Windows are centered.
Probe trihedral(const Frame& frame, const std::optional<WindowSize>& size = {});

// Vanes (1 to kMaxSheets) that touch along the probe's up axis; vane k is the plane z = 0 turned by 360 k / vanes
// degrees about it, and reaches from the axis outward: window [0, W] x [-H/2, H/2]. Without a size it is [0, 2R] x
// [-R, R], where R is half of the bounds' diagonal. That covers everything if the axis passes through the center of the
// bounds.
Probe paddlewheel(const Frame& frame, const Box& bounds, int vanes = 3, const std::optional<WindowSize>& size = {});

// Returns true for a window as large as that, which reaches around everything. Nobody has chosen where it ends.
bool reachesAround(const Window& window, const Box& bounds);

// Parallel sheets at these distances along the probe's normal. Windows are centered.
Probe stack(const Frame& frame, std::span<const double> offsets, const std::optional<WindowSize>& size = {});

// Returns the offsets of `sheets` sheets that are spread evenly over the bounds along the frame's normal. Each is in
// the middle of one of `sheets` slabs of equal thickness, so none only touches the bounds.
std::vector<double> evenOffsets(const Frame& frame, const Box& bounds, int sheets = 5);

} // namespace vp::probe
