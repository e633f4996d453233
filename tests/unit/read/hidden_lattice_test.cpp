// A lattice with hidden cells is an unstructured grid that still knows its subscripts.
#include "read/cell_types.h"
#include "read/check_mesh.h"
#include "read/read.h"
#include "sample_files.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLRectilinearGridWriter.h>

#include <gtest/gtest.h>

using namespace vp;

namespace
{

// 4 x 3 x 2 cells of the sizes 1, 2 and 3.
void writeWithHidden(const std::string& path, const std::vector<vtkIdType>& hidden)
{
	vtkNew<vtkRectilinearGrid> grid;
	grid->SetDimensions(5, 4, 3);
	const auto axis = [](int points, double step)
	{
		vtkNew<vtkDoubleArray> places;
		for (int i = 0; i < points; ++i)
			places->InsertNextValue(i * step);
		return vtkSmartPointer<vtkDoubleArray>(places);
	};
	grid->SetXCoordinates(axis(5, 1.0));
	grid->SetYCoordinates(axis(4, 2.0));
	grid->SetZCoordinates(axis(3, 3.0));
	vtkNew<vtkUnsignedCharArray> ghosts;
	ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
	ghosts->SetNumberOfValues(grid->GetNumberOfCells());
	ghosts->FillValue(0);
	for (const vtkIdType cell : hidden)
		ghosts->SetValue(cell, vtkDataSetAttributes::HIDDENCELL);
	grid->GetCellData()->AddArray(ghosts);
	vtkNew<vtkXMLRectilinearGridWriter> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(grid);
	writer->Write();
}

grid::CellList cellsOf(std::vector<std::uint8_t> types)
{
	grid::CellList cells;
	cells.types = std::move(types);
	return cells;
}

} // namespace

TEST(HiddenLattice, KnowsItsCellsByTheirSubscripts)
{
	const TemporaryFolder folder;
	const std::vector<vtkIdType> hidden{0, 5, 6, 23};
	writeWithHidden(folder / "some.vtr", hidden);
	const auto set = read::readInputs({folder / "some.vtr"}, {}, nullptr);
	ASSERT_TRUE(set) << set.error().message;
	const grid::Block& block = set->blocks.at(0);
	const auto& grid = std::get<grid::UnstructuredGrid>(block.grid);
	const auto lattice = grid::latticeCellsOf(block);
	ASSERT_TRUE(lattice);
	EXPECT_EQ(lattice->lattice().points(), (std::array<std::uint32_t, 3>{5, 4, 3}));
	std::size_t visible = 0;
	for (std::uint32_t k = 0; k < 2; ++k)
		for (std::uint32_t j = 0; j < 3; ++j)
			for (std::uint32_t i = 0; i < 4; ++i)
			{
				const CellId cell = lattice->at({i, j, k});
				EXPECT_EQ(cell == kNoCell, std::ranges::count(hidden, i + 4 * (j + 3 * k)) == 1);
				if (cell == kNoCell)
					continue;
				++visible;
				EXPECT_LT(glm::length(grid::cellCenter(grid, cell) - Vec3(i + 0.5, 2.0 * j + 1.0, 3.0 * k + 1.5)),
				          1e-12);
			}
	EXPECT_EQ(visible, grid.cellCount());
}

TEST(HiddenLattice, ThatItsCellsCannotBeIsRefused)
{
	using namespace vp::read;
	const grid::Lattice lattice({3, 2, 2});
	EXPECT_NO_THROW(checkLattice(lattice, 12, cellsOf({kEmptyCell, kHexahedron})));
	EXPECT_THROW(checkLattice(lattice, 11, cellsOf({kEmptyCell, kHexahedron})), Unusable);
	EXPECT_THROW(checkLattice(lattice, 12, cellsOf({kHexahedron})), Unusable);
	EXPECT_THROW(checkLattice(lattice, 12, cellsOf({kHexahedron, kVoxel})), Unusable);
	EXPECT_THROW(checkLattice(lattice, 12, cellsOf({kTetra, kHexahedron})), Unusable);
	grid::CellList parts = cellsOf({kHexahedron, kHexahedron});
	parts.source_cells = std::vector<std::int64_t>{0, 0};
	EXPECT_THROW(checkLattice(lattice, 12, parts), Unusable);
}
