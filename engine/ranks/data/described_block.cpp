#include "ranks/data/described_block.h"

#include "grid/cell_places.h"
#include "ranks/data/imaging_message.h"

#include <memory>
#include <string>
#include <utility>
#include <variant>

namespace vp::ranks
{

Share::Counts countsOf(const grid::Block& block)
{
	Share::Counts counts;
	counts.linear_cells = cellsHere(block);
	counts.linear_points = std::visit([](const auto& grid) { return grid.pointCount(); }, block.grid);
	const auto* cells = std::get_if<grid::UnstructuredGrid>(&block.grid);
	counts.cells = cells && !block.runs ? cells->sourceCellCount() : counts.linear_cells;
	counts.points = cells ? cells->sourcePointCount() : counts.linear_points;
	return counts;
}

void put(MessageWriter& to, const grid::Block& block, std::size_t whole)
{
	const Share::Counts counts = countsOf(block);
	to.put(block.grid.index());
	to.put(block.bounds);
	for (const std::size_t count : {counts.cells, counts.points, counts.linear_cells, counts.linear_points, whole})
		to.put(count);
	to.put(block.name);
	to.put(block.length_units);
	putImaging(to, block.imaging);
	to.put(block.arrays_left_out.size());
	for (const std::string& name : block.arrays_left_out)
		to.put(name);
	to.put(block.fields.size());
	for (const grid::Field& field : block.fields)
	{
		to.put(field.name);
		to.put(field.units);
		to.put(field.association);
		to.put(field.components);
		to.put(field.type);
		to.put(field.categorical);
	}
}

DescribedBlock described(MessageReader& from)
{
	DescribedBlock block;
	block.kind = from.get<std::size_t>();
	block.bounds = from.get<Box>();
	for (std::size_t* count : {&block.counts.cells, &block.counts.points, &block.counts.linear_cells,
	                           &block.counts.linear_points, &block.whole})
		*count = from.get<std::size_t>();
	block.block.name = from.getText();
	block.block.length_units = from.getText();
	block.block.imaging = getImaging(from);
	for (auto left = from.get<std::size_t>(); left > 0; --left)
		block.block.arrays_left_out.push_back(from.getText());
	for (auto left = from.get<std::size_t>(); left > 0; --left)
	{
		grid::Field& field = block.block.fields.emplace_back();
		field.name = from.getText();
		field.units = from.getText();
		field.association = from.get<grid::Association>();
		field.components = from.get<int>();
		field.type = from.get<grid::NumberType>();
		field.categorical = from.get<bool>();
	}
	return block;
}

grid::Block standIn(DescribedBlock&& described)
{
	grid::Block block = std::move(described.block);
	const grid::AnyGrid grids[] = {grid::UniformGrid(), grid::RectilinearGrid(), grid::CurvilinearGrid(),
	                               grid::UnstructuredGrid()};
	block.grid = grids[described.kind];
	block.bounds = described.bounds;
	// Not finishBlock(): it would name cells where hopping starts.
	block.tree = std::make_shared<grid::LazyBlockTree>();
	block.cell_places = std::make_shared<grid::LazyCellPlaces>();
	return block;
}

} // namespace vp::ranks
