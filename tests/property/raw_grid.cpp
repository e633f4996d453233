#include "raw_grid.h"

#include "test_grids.h"

#include <algorithm>
#include <numeric>

namespace vp::test
{

namespace
{

grid::Points pointsOf(const RawBlock& raw)
{
	std::vector<double> xyz;
	for (const Vec3& p : raw.points)
		xyz.insert(xyz.end(), {p.x, p.y, p.z});
	if (raw.floats)
		return grid::Points(Array<float>(std::vector<float>(xyz.begin(), xyz.end())));
	return grid::Points(Array<double>(std::move(xyz)));
}

grid::UnstructuredGrid cellsOf(const RawBlock& raw)
{
	CellListMaker maker;
	for (const RawCell& cell : raw.cells)
		if (cell.type == 42)
			maker.polyhedron(cell.faces);
		else
			maker.cell(cell.type, cell.ids);
	return grid::UnstructuredGrid::build(pointsOf(raw), maker.list());
}

// Coordinate `axis` of the lattice's points along it.
std::vector<double> axisOf(const RawBlock& raw, int axis)
{
	std::size_t step = 1;
	for (int a = 0; a < axis; ++a)
		step *= raw.points_along[a];
	std::vector<double> values;
	for (std::uint32_t i = 0; i < raw.points_along[axis]; ++i)
		values.push_back(raw.points[i * step][axis]);
	return values;
}

grid::AnyGrid gridOf(const RawBlock& raw)
{
	switch (raw.kind)
	{
	case RawKind::image:
		return grid::UniformGrid(raw.points_along, raw.points[0],
		                         {axisOf(raw, 0)[1] - raw.points[0].x, axisOf(raw, 1)[1] - raw.points[0].y,
		                          axisOf(raw, 2)[1] - raw.points[0].z});
	case RawKind::rectilinear:
		return grid::RectilinearGrid(axisOf(raw, 0), axisOf(raw, 1), axisOf(raw, 2));
	case RawKind::curvilinear:
		return grid::CurvilinearGrid(raw.points_along, pointsOf(raw));
	default:
		return cellsOf(raw);
	}
}

} // namespace

grid::BlockSet build(const RawSet& raw)
{
	grid::BlockSet set;
	for (std::size_t b = 0; b < raw.blocks.size(); ++b)
	{
		grid::Block& block = set.blocks.emplace_back();
		block.name = raw.name + " " + std::to_string(b);
		block.grid = gridOf(raw.blocks[b]);
		addTestFields(block);
		grid::finishBlock(block);
	}
	grid::matchInterfaces(set);
	return set;
}

RawBlock shuffled(const RawBlock& raw, std::mt19937& random, std::vector<std::size_t>& order)
{
	std::vector<std::size_t> place(raw.points.size()); // new number of each point
	std::iota(place.begin(), place.end(), std::size_t(0));
	std::ranges::shuffle(place, random);
	order.resize(raw.cells.size());
	std::iota(order.begin(), order.end(), std::size_t(0));
	std::ranges::shuffle(order, random);
	RawBlock made = raw;
	for (std::size_t p = 0; p < place.size(); ++p)
		made.points[place[p]] = raw.points[p];
	const auto rename = [&](std::vector<std::int64_t>& ids)
	{
		for (std::int64_t& id : ids)
			id = static_cast<std::int64_t>(place[id]);
	};
	for (std::size_t c = 0; c < order.size(); ++c)
	{
		made.cells[c] = raw.cells[order[c]];
		rename(made.cells[c].ids);
		std::ranges::for_each(made.cells[c].faces, rename);
	}
	return made;
}

} // namespace vp::test
