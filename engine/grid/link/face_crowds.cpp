#include "grid/link/face_crowds.h"

#include "grid/link/adjacency.h"

namespace vp::grid
{

namespace
{

// As many cells on one face know all the others; in larger crowds (cells given thousands of times) each knows the one
// before and the one after, which still leads to all.
constexpr std::size_t kMaxLinked = 64;

void linkCrowd(std::span<const std::uint32_t> slots, const std::function<CellId(std::uint32_t)>& cellOf,
               const std::function<std::uint32_t&(std::uint32_t)>& across, std::vector<std::vector<CellId>>& several)
{
	std::vector<CellId> cells;
	for (const std::uint32_t slot : slots)
	{
		across(slot) = kNoCell;
		cells.push_back(cellOf(slot));
	}
	std::ranges::sort(cells);
	cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
	const std::size_t reach = cells.size() > kMaxLinked ? 1 : cells.size() - 1;
	for (const std::uint32_t slot : slots)
	{
		const std::size_t own = std::ranges::lower_bound(cells, cellOf(slot)) - cells.begin();
		for (std::size_t step = 1; step <= reach; ++step)
		{
			addNeighbor(across(slot), cells[(own + step) % cells.size()], several);
			if (cells.size() > kMaxLinked)
				addNeighbor(across(slot), cells[(own + cells.size() - step) % cells.size()], several);
		}
	}
}

} // namespace

void linkCrowds(std::vector<std::vector<std::uint32_t>> crowds, const std::function<CellId(std::uint32_t)>& cellOf,
                const std::function<std::uint32_t&(std::uint32_t)>& across, std::vector<std::vector<CellId>>& several)
{
	for (std::vector<std::uint32_t>& slots : crowds)
		std::ranges::sort(slots);
	std::ranges::sort(crowds);
	for (const std::vector<std::uint32_t>& slots : crowds)
		linkCrowd(slots, cellOf, across, several);
}

void addNeighbor(std::uint32_t& across, CellId other, std::vector<std::vector<CellId>>& several)
{
	if (across == kNoCell)
		across = other;
	else if (across >= kMaxBlockIds)
	{
		std::vector<CellId>& cells = several[across - kMaxBlockIds];
		const auto place = std::ranges::lower_bound(cells, other);
		if (place == cells.end() || *place != other)
			cells.insert(place, other);
	}
	else if (across != other)
	{
		several.push_back({std::min<CellId>(across, other), std::max<CellId>(across, other)});
		across = kMaxBlockIds + static_cast<std::uint32_t>(several.size() - 1);
	}
}

} // namespace vp::grid
