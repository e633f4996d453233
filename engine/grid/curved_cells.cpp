#include "grid/curved_cells.h"

#include <algorithm>
#include <utility>

namespace vp::grid
{

namespace
{

/// The same cells without the nodes on their edges.
template <class Id>
CellList cornersOf(const CurvedCells& curved, std::span<const Id> nodes)
{
	std::vector<std::uint8_t> types(curved.cells.types.span().begin(), curved.cells.types.span().end());
	std::vector<std::int64_t> offsets{0};
	std::vector<Id> corners;
	offsets.reserve(types.size() + 1);
	corners.reserve(4 * types.size());
	for (std::size_t c = 0; c < types.size(); ++c)
	{
		if (curved.isQuadratic(c))
			types[c] = kTetra;
		const int count = isSliceable(types[c]) ? topology(shapeOf(types[c])).points : 0;
		const auto first = nodes.begin() + static_cast<std::ptrdiff_t>(curved.start(c));
		corners.insert(corners.end(), first, first + count);
		offsets.push_back(static_cast<std::int64_t>(corners.size()));
	}
	CellList list;
	list.types = Array(std::move(types));
	list.offsets = Array(std::move(offsets));
	list.connectivity = std::move(corners);
	return list;
}

} // namespace

void takeCurvedCells(Block& block, CurvedCells curved)
{
	CellList corners = curved.cells.connectivity.as([&](auto nodes) { return cornersOf(curved, nodes); });
	block.grid = UnstructuredGrid::listed(curved.points, std::move(corners));
	finishBlock(block);
	for (std::size_t c = 0; c < curved.cells.size(); ++c)
		if (curved.isQuadratic(c))
			for (int n = 4; n < kQuadraticTetraNodes; ++n)
				block.bounds.include(
				    curved.points[static_cast<std::size_t>(curved.cells.connectivity[curved.start(c) + n])]);
	block.curved = std::make_shared<const CurvedCells>(std::move(curved));
}

} // namespace vp::grid
