#include "grid/interfaces.h"

#include <algorithm>
#include <utility>

namespace vp::grid
{

BlockSeams::BlockSeams(std::vector<SeamLink> links) : links_(std::move(links))
{
	std::ranges::sort(links_);
}

std::span<const SeamLink> BlockSeams::ofCell(CellId cell) const
{
	return {std::ranges::lower_bound(links_, cell, {}, &SeamLink::cell),
	        std::ranges::upper_bound(links_, cell, {}, &SeamLink::cell)};
}

std::span<const SeamLink> BlockSeams::of(CellId cell, std::uint32_t face) const
{
	const auto key = [](const SeamLink& link) { return std::pair(link.cell, link.face); };
	const std::pair wanted(cell, face);
	return {std::ranges::lower_bound(links_, wanted, {}, key), std::ranges::upper_bound(links_, wanted, {}, key)};
}

} // namespace vp::grid
