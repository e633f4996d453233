#include "pack_partitions.h"

#include <cstring>
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

void gatherIds(const PackDivision& division, const PackPartitions& partitions, std::size_t part, std::byte* to)
{
	thread_local std::vector<std::int32_t> within; // the place of a point in its partition
	if (const auto points = division.points(part); !points.empty() && points.back() >= within.size())
		within.resize(points.back() + std::size_t(1));
	auto next = static_cast<std::int32_t>(partitions.before(part).points);
	for (const std::uint32_t point : division.points(part))
		within[point] = next++;
	division.withLists(
	    [&](const auto* offsets, const auto* ids)
	    {
		    for (const std::uint32_t cell : division.cells(part))
			    for (auto i = offsets[cell]; i < division.endOf(cell, offsets); ++i, to += sizeof(std::int32_t))
				    std::memcpy(to, &within[static_cast<std::size_t>(ids[i])], sizeof(std::int32_t));
	    });
}

void gatherOffsets(const PackDivision& division, const PackPartitions& partitions, std::size_t part, std::byte* to)
{
	auto end = static_cast<std::int32_t>(partitions.before(part).ids);
	const auto putEnd = [&]
	{
		std::memcpy(to, &end, sizeof(end));
		to += sizeof(end);
	};
	if (partitions.before(part).cells == 0)
		putEnd();
	division.withLists(
	    [&](const auto* offsets, const auto*)
	    {
		    for (const std::uint32_t cell : division.cells(part))
		    {
			    end += static_cast<std::int32_t>(division.endOf(cell, offsets) - offsets[cell]);
			    putEnd();
		    }
	    });
}

} // namespace vp::reader::convert
