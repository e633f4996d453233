#include "refine/cell_kinds.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace vp::refine
{

CellKinds::CellKinds(const grid::CurvedCells& curved) : curved_(curved)
{
	const std::size_t count = curved.cells.size();
	std::array<bool, 256> there{};
	for (std::size_t c = 0; c < count; ++c)
		there[curved.cells.types[c]] = true;
	bool any = false; // whose type does not tell their degrees
	for (std::size_t type = 0; type < there.size(); ++type)
	{
		const auto of = static_cast<std::uint8_t>(type);
		any |= there[type] && grid::hasDegrees(of);
		if (!there[type] || grid::hasDegrees(of) || !(grid::isCurved(of) || grid::isSliceable(of)))
			continue;
		only_quadratic_ &= of == grid::kQuadraticTetra || grid::isSliceable(of);
		const int nodes = grid::isCurved(of) ? grid::fixedNodes(of) : grid::topology(grid::shapeOf(of)).points;
		by_type_[type] = static_cast<std::uint16_t>(kinds_.size());
		kinds_.push_back(std::make_unique<CellKind>(of, static_cast<std::size_t>(nodes), std::array{1, 1, 1}));
	}
	if (!any)
		return;
	numbers_.resize(count);
	std::map<std::tuple<std::uint8_t, std::array<int, 3>, std::size_t>, std::uint16_t> known;
	for (std::size_t c = 0; c < count; ++c)
	{
		const std::uint8_t type = curved.cells.types[c];
		if (!grid::hasDegrees(type))
		{
			numbers_[c] = by_type_[type];
			continue;
		}
		only_quadratic_ &= curved.isQuadratic(c);
		const std::array<int, 3> degrees = curved.degreesOf(c);
		const auto [kind, is_new] =
		    known.try_emplace(std::tuple(type, degrees, curved.nodes(c)), static_cast<std::uint16_t>(kinds_.size()));
		if (is_new)
			kinds_.push_back(std::make_unique<CellKind>(type, curved.nodes(c), degrees));
		numbers_[c] = kind->second;
	}
}

} // namespace vp::refine
