#pragma once

#include "base/place_key.h"
#include "base/vec.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace vp::ranks
{

/// Bins of a lattice over space, by keys that are the same at all ranks.
class SpaceBins
{
public:
	explicit SpaceBins(double side) : side_(side) {}

	/// The bins that the box between two corners may reach into, with a place in each. It is no larger than a bin.
	std::map<std::uint64_t, Vec3> of(const Vec3& a, const Vec3& b) const
	{
		std::map<std::uint64_t, Vec3> keys;
		for (int corner = 0; corner < 8; ++corner)
			keys.insert(at({corner & 1 ? a.x : b.x, corner & 2 ? a.y : b.y, corner & 4 ? a.z : b.z}));
		return keys;
	}
	std::pair<std::uint64_t, Vec3> at(const Vec3& place) const
	{
		const Vec3 cell(std::floor(place.x / side_), std::floor(place.y / side_), std::floor(place.z / side_));
		return {placeKey(cell), side_ * (cell + 0.5)};
	}

private:
	double side_;
};

} // namespace vp::ranks
