#include "grid/check/memory.h"

#include "grid/curved/curved_cells.h"

namespace vp::grid
{

namespace
{

template <class T>
std::size_t bytesOf(const std::vector<T>& list)
{
	return list.capacity() * sizeof(T);
}

std::size_t geometryOf(const UniformGrid&)
{
	return 0; // origin and spacing
}

std::size_t geometryOf(const RectilinearGrid& grid)
{
	const auto [i, j, k] = grid.points();
	return (std::size_t(i) + j + k) * sizeof(double);
}

std::size_t geometryOf(const CurvilinearGrid& grid)
{
	return grid.coordinates().bytes();
}

std::size_t geometryOf(const UnstructuredGrid& grid)
{
	return grid.geometryBytes();
}

std::size_t adjacencyOf(const Lattice&)
{
	return 0; // arithmetic
}

std::size_t adjacencyOf(const UnstructuredGrid& grid)
{
	return grid.adjacencyBytes();
}

void add(const Block& block, Memory& memory)
{
	if (block.runs)
	{
		memory.geometry += block.runs->bytesAfter({});
		return;
	}
	memory.geometry += std::visit([](const auto& grid) { return geometryOf(grid); }, block.grid);
	memory.adjacency += std::visit([](const auto& grid) { return adjacencyOf(grid); }, block.grid);
	if (block.curved) // the grid has the points
		memory.geometry += block.curved->cells.bytes();
	for (const Field& field : block.fields)
		memory.arrays += field.bytes.size(); // parts of stored arrays are counted by parts::KeptParts
	memory.boundary += bytesOf(block.boundary.faces) + bytesOf(block.boundary.corners) +
	                   bytesOf(block.boundary.patches) + bytesOf(block.boundary.groups) + bytesOf(block.vantage);
	memory.folds += bytesOf(block.inverted) + block.inverted_tree.bytes();
	if (block.tree)
		memory.trees += block.tree->bytes();
	if (block.cell_places)
		memory.trees += block.cell_places->bytes();
}

} // namespace

Memory memoryOf(const BlockSet& blocks)
{
	Memory memory;
	for (const Block& block : blocks.blocks)
		add(block, memory);
	for (const BlockSeams& seams : blocks.interfaces.blocks)
		memory.seams += seams.all().size_bytes();
	for (const Patch& patch : blocks.patches)
		memory.boundary += bytesOf(patch.faces);
	return memory;
}

} // namespace vp::grid
