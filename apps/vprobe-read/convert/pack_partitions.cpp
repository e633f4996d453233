#include "pack_partitions.h"

#include <limits>

namespace vp::reader::convert
{

PackPartitions::PackPartitions(const PackDivision& division)
{
	constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
	for (std::size_t part = 0; part < division.parts(); ++part)
	{
		const auto points = static_cast<std::int64_t>(division.points(part).size());
		const auto ids = static_cast<std::int64_t>(division.ids(part));
		if (partitions_.empty() || partitions_.back().points + points > most || partitions_.back().ids + ids > most)
			partitions_.emplace_back();
		Counts& all = partitions_.back();
		before_.push_back(all);
		all.points += points;
		all.cells += static_cast<std::int64_t>(division.cells(part).size());
		all.ids += ids;
	}
}

} // namespace vp::reader::convert
