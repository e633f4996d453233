#pragma once

#include "base/huge_vector.h"
#include "base/vec.h"

#include <cstddef>
#include <cstdint>

namespace vp::grid
{

// Positions along a Morton (Z-order) curve through the smallest cube around a box, 21 bits an axis.
class MortonCurve
{
public:
	explicit MortonCurve(const Box& bounds);

	static constexpr std::uint64_t kLast = (std::uint64_t(1) << 63) - 1;

	// 63 bits. A position with a NaN comes last, one outside the box is moved onto it.
	std::uint64_t operator()(const Vec3& position) const;

private:
	Vec3 lo_{0.0};
	double scale_ = 0.0;
};

struct KeyedId
{
	std::uint64_t key;
	std::uint32_t id;
};

using KeyedIds = HugeVector<KeyedId>;

// Sorts by key, equal keys in the order they came; on all cores, and the same for any number of them.
void sortByKey(KeyedIds& items);

} // namespace vp::grid
