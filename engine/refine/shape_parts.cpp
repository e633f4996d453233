#include "refine/shape_refiner.h"

namespace vp::refine
{

/// The parts cell by cell, with the points that they have.
PartList ShapeRefiner::list() const
{
	std::vector<std::size_t> starts(cells_.size() + 1, 0);
	for (const DonePart& part : done_)
		++starts[part.near + 1];
	for (std::size_t i = 0; i < cells_.size(); ++i)
		starts[i + 1] += starts[i];
	std::vector<std::uint32_t> numbers(points_.size(), EdgeTable::kUnknown);
	for (const DonePart& part : done_)
		for (const std::uint32_t point : part.points)
			numbers[point] = 0;
	RawVector<PartPoint> points;
	for (std::uint32_t p = 0; p < points_.size(); ++p)
	{
		if (numbers[p] == EdgeTable::kUnknown)
			continue;
		numbers[p] = static_cast<std::uint32_t>(points.size());
		points.push_back(points_[p]);
		points.back().position = positionOf(p);
	}
	RawVector<std::uint32_t> corners(4 * done_.size());
	RawVector<std::uint32_t> cells(done_.size());
	for (const DonePart& part : done_)
	{
		const std::size_t at = starts[part.near]++;
		for (std::size_t c = 0; c < 4; ++c)
			corners[4 * at + c] = numbers[part.points[c]];
		cells[at] = cells_[part.near].cell;
	}
	return PartList(std::move(points), std::move(corners), RawVector<std::uint8_t>(done_.size(), grid::kTetra),
	                std::move(cells));
}

} // namespace vp::refine
