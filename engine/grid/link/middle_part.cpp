#include "grid/link/middle_part.h"

#include "grid/cell_list.h"

#include <algorithm>

namespace vp::grid
{

namespace
{

struct Range
{
	std::uint32_t begin;
	std::uint32_t end;
};

Range middleOf(std::size_t count, std::size_t wanted)
{
	const std::size_t taken = std::min(count, wanted);
	const std::size_t begin = (count - taken) / 2;
	return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + taken)};
}

std::vector<CellId> middleCells(const Lattice& grid, std::size_t side)
{
	const Range i_range = middleOf(grid.cells()[0], side);
	const Range j_range = middleOf(grid.cells()[1], side);
	const Range k_range = middleOf(grid.cells()[2], side);
	std::vector<CellId> cells;
	for (std::uint32_t k = k_range.begin; k < k_range.end; ++k)
		for (std::uint32_t j = j_range.begin; j < j_range.end; ++j)
			for (std::uint32_t i = i_range.begin; i < i_range.end; ++i)
				cells.push_back(grid.cell(i, j, k));
	return cells;
}

std::vector<CellId> middleCells(const UnstructuredGrid& grid, std::size_t side)
{
	const Range range = middleOf(grid.cellCount(), side * side * side);
	std::vector<CellId> cells;
	for (CellId c = range.begin; c < range.end; ++c)
		if (grid.shape(c) != CellShape::polyhedron)
			cells.push_back(c);
	return cells;
}

std::uint8_t vtkType(CellShape shape)
{
	for (const std::uint8_t type : {kTetra, kPyramid, kWedge})
		if (shapeOf(type) == shape)
			return type;
	return kHexahedron;
}

Points pointsAt(const std::vector<Vec3>& places)
{
	std::vector<float> floats;
	std::vector<double> doubles;
	bool exact = true;
	for (const Vec3& place : places)
		for (int axis = 0; axis < 3; ++axis)
		{
			doubles.push_back(place[axis]);
			floats.push_back(static_cast<float>(place[axis]));
			exact = exact && static_cast<double>(floats.back()) == place[axis];
		}
	return exact ? Points(Array<float>(std::move(floats))) : Points(Array<double>(std::move(doubles)));
}

template <class G>
UnstructuredGrid explicitCells(const G& grid, std::span<const CellId> cells)
{
	std::vector<PointId> used;
	for (const CellId cell : cells)
		for (const PointId p : grid.cellPoints(cell))
			used.push_back(p);
	std::ranges::sort(used);
	used.erase(std::unique(used.begin(), used.end()), used.end());

	std::vector<std::uint8_t> types;
	std::vector<std::int64_t> offsets{0};
	std::vector<std::int64_t> connectivity;
	for (const CellId cell : cells)
	{
		types.push_back(vtkType(grid.shape(cell)));
		for (const PointId p : grid.cellPoints(cell))
			connectivity.push_back(std::ranges::lower_bound(used, p) - used.begin());
		offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
	}
	std::vector<Vec3> places;
	for (const PointId p : used)
		places.push_back(grid.point(p));
	CellList list;
	list.types = std::move(types);
	list.offsets = std::move(offsets);
	list.connectivity = std::move(connectivity);
	return UnstructuredGrid::build(pointsAt(places), list);
}

} // namespace

Block middlePart(const Block& block, std::size_t side)
{
	Block part;
	part.name = block.name;
	part.grid = std::visit([&](const auto& grid) { return explicitCells(grid, middleCells(grid, side)); }, block.grid);
	finishBlock(part);
	return part;
}

} // namespace vp::grid
