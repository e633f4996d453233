#include "read/build_block.h"

#include "grid/curved/curved_cells.h"
#include "read/geometry.h"

namespace vp::read
{

grid::Block buildBlock(CheckedBlock&& checked, std::string name, bool identifies_geometry, bool for_one_cut,
                       double tolerance)
{
	grid::Block block;
	block.name = std::move(name);
	block.fields = std::move(checked.fields);
	block.length_units = std::move(checked.length_units);
	block.imaging = std::move(checked.imaging);
	block.geometry = identifies_geometry && !checked.runs ? geometryOf(checked) : 0; // cells in runs were not read yet
	block.arrays_left_out = std::move(checked.arrays_left_out);
	block.hidden_lattice = checked.hidden_lattice;
	block.whole = std::move(checked.whole);
	block.runs = std::move(checked.runs);
	std::visit(
	    [&](auto&& mesh)
	    {
		    if constexpr (std::is_same_v<std::decay_t<decltype(mesh)>, CellMesh>)
		    {
			    if (mesh.curved)
				    return takeCurvedCells(block, {std::move(mesh.points), std::move(mesh.cells), tolerance,
				                                   std::move(mesh.degrees), std::move(mesh.weights)});
			    block.grid = block.runs
			                     ? grid::UnstructuredGrid::listedInRuns(std::move(mesh.points), std::move(mesh.cells))
			                     : grid::UnstructuredGrid::listed(std::move(mesh.points), std::move(mesh.cells));
		    }
		    else
			    block.grid = std::move(mesh);
		    finishBlock(block, for_one_cut);
	    },
	    std::move(checked.mesh));
	return block;
}

} // namespace vp::read
