#pragma once

#include "probe/path.h"

#include <span>

namespace vp::probe
{

// Smooth motion through the keys of a path: at the time of a key exactly its frame, in between of continuous velocity,
// turning included.
//
// Positions are a cubic Hermite spline whose velocity at a key is that of the parabola through it and its neighbors
// (Catmull-Rom's for even times). Orientations are its counterpart on the sphere of unit quaternions, a Hermite
// quaternion curve of cumulative basis (Kim, Kim and Shin 1995, "A General Construction Scheme for Unit Quaternion
// Curves with Simple High Order Derivatives"), with angular velocities chosen alike. Between two keys the turn is the
// shorter one. Two keys alone give a straight line and an even turn. A probe that rests does not move by a bit.
//
// keys: 2 or more, times rising. period: 0, or the time in which a closed path is run through, more than the keys take;
// time may then be beyond them.
Frame splinePose(std::span<const Key> keys, double period, double time);

} // namespace vp::probe
