#pragma once

#include "probe/probe.h"

#include <cstddef>
#include <optional>

namespace vp::interact
{

// The part of a probe that moves: one sheet, or the whole probe if none is given.
using Part = std::optional<std::size_t>;

// Returns a part's frame in the world.
probe::Frame frameOf(const probe::Probe& probe, const Part& part);

// The probe with a part at another frame, given in the world.
probe::Probe withFrame(const probe::Probe& probe, const Part& part, const probe::Frame& frame);

// way: in the world.
probe::Probe moved(const probe::Probe& probe, const Part& part, const Vec3& way);

// About an axis of the world (any length but zero) through the part's own origin, which stays to the last bit.
probe::Probe turned(const probe::Probe& probe, const Part& part, const Vec3& axis, double degrees);

// Turned until its normal points that way (any length but zero), by the least angle that does; against the normal, half
// about its up. Onto an axis of the world it is exact; the origin stays.
probe::Frame normalTo(const probe::Frame& frame, const Vec3& direction);

// Turned by the least angle until its normal is exactly the nearest of the world's axes or their negatives; as it was
// where that is farther than `most_degrees`. 55 degrees is the farthest that one can be.
probe::Frame snapNormal(const probe::Frame& frame, double most_degrees = 90.0);

// The same for a part of a probe: unchanged, to the last bit, where nothing snaps.
probe::Probe withNormalSnapped(const probe::Probe& probe, const Part& part, double most_degrees = 90.0);
probe::Probe withNormal(const probe::Probe& probe, const Part& part, const Vec3& direction);

// Back to where a probe stands that nobody moved: at the center of the bounds, normal z and up y. Its sheets stay as
// they are within it.
probe::Probe resetPlace(const probe::Probe& probe, const Box& bounds);

} // namespace vp::interact
