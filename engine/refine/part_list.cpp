#include "refine/part_list.h"

namespace vp::refine
{

void PartList::append(const PartList& other)
{
	if (types_.size() + other.types_.size() > kMaxParts)
		throw TooManyParts("too many parts");
	// A point comes after those that it lies between.
	RawVector<std::uint32_t> numbers(other.points_.size());
	for (std::size_t p = 0; p < numbers.size(); ++p)
	{
		const PartPoint& point = other.points_[p];
		const auto [a, b] = point.source;
		numbers[p] = point.cell == PartPoint::kNode
		                 ? node(a, point.position)
		                 : between(numbers[a], numbers[b], point.position, point.place, point.cell);
	}
	corners_.reserve(corners_.size() + other.corners_.size());
	for (const std::uint32_t corner : other.corners_)
		corners_.push_back(numbers[corner]);
	types_.insert(types_.end(), other.types_.begin(), other.types_.end());
	cells_.insert(cells_.end(), other.cells_.begin(), other.cells_.end());
}

} // namespace vp::refine
