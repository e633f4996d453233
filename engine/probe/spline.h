#pragma once

#include "probe/path.h"

#include <span>

namespace vp::probe
{

// Smooth motion through the keys of a path. At the time of a key it is exactly its frame. Velocity and angular velocity
// are continuous.
//
// Positions are a cubic Hermite spline whose velocity at a key is that of the parabola through it and its neighbors
// (Catmull-Rom's for even times). Orientations are its counterpart on the sphere of unit quaternions, a Hermite
// quaternion curve of cumulative basis (Kim, Kim and Shin 1995, "A General Construction Scheme for Unit Quaternion
// Curves with Simple High Order Derivatives"), with angular velocities chosen in the same way. Between two keys the
// turn is the shorter one. Two keys alone give a straight line and an even turn. A probe that rests stays exactly
// there.
//
// keys: 2 or more, with rising times. period: 0, or the time of one round of a closed path, which is more than the keys
// take. Then the time may be beyond them.
Frame splinePose(std::span<const Key> keys, double period, double time);

} // namespace vp::probe
