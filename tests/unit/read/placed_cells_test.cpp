// Points whose coordinates are no numbers: those of no cell do not matter, and cells that have one are left out.
#include "base/messages.h"
#include "curved_samples.h"
#include "grid/curved/curved_cells.h"
#include "read/read.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLStructuredGridWriter.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

using namespace vp;

namespace
{

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Reading
{
	Result<grid::BlockSet> set;
	std::string words; // on standard error
};

Reading readOf(const std::string& path, double refine = 0.0)
{
	std::string words;
	const MessageListener listener([&](Severity, std::string_view line) { words.append(line).append("\n"); });
	auto set = read::readInputs({path}, {{}, "", refine}, nullptr);
	return {std::move(set), std::move(words)};
}

bool tells(const Reading& reading, const std::string& words)
{
	return reading.words.find(words) != std::string::npos;
}

// A row of unit cubes along x in double precision, with a point more, and one set to another place.
vtkSmartPointer<vtkUnstructuredGrid> rowOfCubes(int count, vtkIdType moved, const std::array<double, 3>& place)
{
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	for (int i = 0; i <= count; ++i)
		for (const auto& [y, z] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
			points->InsertNextPoint(i, y, z);
	points->InsertNextPoint(kNan, -1e300, std::numeric_limits<double>::infinity());
	if (moved >= 0)
		points->SetPoint(moved, place.data());
	grid->SetPoints(points);
	for (vtkIdType a = 0; a < 4 * count; a += 4)
	{
		const std::array<vtkIdType, 8> ids = {a, a + 4, a + 5, a + 1, a + 3, a + 7, a + 6, a + 2};
		grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids.data());
	}
	return grid;
}

void expectBox(const grid::BlockSet& set, const Vec3& lo, const Vec3& hi)
{
	EXPECT_EQ(set.bounds().lo, lo);
	EXPECT_EQ(set.bounds().hi, hi);
}

} // namespace

TEST(PlacedCells, PointsOfNoCellMayLieAnywhere)
{
	const TemporaryFolder folder;
	writeGrid(rowOfCubes(3, -1, {}), folder / "a.vtu");
	const Reading reading = readOf(folder / "a.vtu");
	ASSERT_TRUE(reading.set) << reading.set.error().message;
	EXPECT_EQ(reading.words, "");
	EXPECT_EQ(reading.set->cellCount(), 3u);
	expectBox(*reading.set, {0, 0, 0}, {3, 1, 1});
	grid::validate(reading.set->blocks[0]);
}

TEST(PlacedCells, CellsWithSuchAPointAreLeftOutAndCounted)
{
	const TemporaryFolder folder;
	for (const auto& [place, moved, left] :
	     {std::tuple(std::array{kNan, 0.0, 0.0}, 0, 1u), std::tuple(std::array{1.0, 0.0, -1e51}, 5, 2u)})
	{
		writeGrid(rowOfCubes(3, moved, place), folder / "a.vtu");
		const Reading reading = readOf(folder / "a.vtu");
		ASSERT_TRUE(reading.set) << reading.set.error().message;
		EXPECT_TRUE(tells(reading, left == 1 ? ": 1 cell is left out" : ": 2 cells are left out")) << reading.words;
		EXPECT_EQ(reading.set->cellCount(), 3 - left);
		expectBox(*reading.set, {left, 0, 0}, {3, 1, 1});
		const grid::Block& block = reading.set->blocks[0];
		grid::validate(block);
		EXPECT_EQ(std::get<grid::UnstructuredGrid>(block.grid).sourceCell(0), left);
	}
	writeGrid(rowOfCubes(1, 3, {0.0, kNan, 0.0}), folder / "none.vtu");
	const Reading none = readOf(folder / "none.vtu");
	ASSERT_FALSE(none.set);
	EXPECT_NE(none.set.error().message.find("every cell has a point without a place; the coordinates of point 3 are "
	                                        "not finite numbers"),
	          std::string::npos)
	    << none.set.error().message;
	// Beside other blocks, one without such cells is as if it were not there.
	writeContents(folder / "both.vtm", "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet>"
	                                   "<DataSet index=\"0\" file=\"none.vtu\"/><DataSet index=\"1\" file=\"a.vtu\"/>"
	                                   "</vtkMultiBlockDataSet></VTKFile>");
	const Reading both = readOf(folder / "both.vtm");
	ASSERT_TRUE(both.set) << both.set.error().message;
	EXPECT_EQ(both.set->blocks.size(), 1u);
	EXPECT_EQ(both.set->cellCount(), 1u);
	EXPECT_TRUE(tells(both, ": 3 cells are left out")) << both.words;
}

// As hidden cells: the others keep their subscripts.
TEST(PlacedCells, CurvilinearGridsHideThem)
{
	const TemporaryFolder folder;
	vtkNew<vtkStructuredGrid> grid;
	grid->SetDimensions(4, 3, 3);
	vtkNew<vtkPoints> points;
	for (int k = 0; k < 3; ++k)
		for (int j = 0; j < 3; ++j)
			for (int i = 0; i < 4; ++i)
				points->InsertNextPoint(i == 3 && j == 1 ? kNan : i, j, k);
	grid->SetPoints(points);
	vtkNew<vtkXMLStructuredGridWriter> writer;
	writer->SetFileName((folder / "a.vts").c_str());
	writer->SetInputData(grid);
	writer->Write();
	const Reading reading = readOf(folder / "a.vts");
	ASSERT_TRUE(reading.set) << reading.set.error().message;
	EXPECT_TRUE(tells(reading, ": 4 cells are left out")) << reading.words;
	EXPECT_EQ(reading.set->cellCount(), 8u);
	expectBox(*reading.set, {0, 0, 0}, {2, 2, 2});
	const grid::Block& block = reading.set->blocks[0];
	ASSERT_TRUE(block.hidden_lattice);
	EXPECT_EQ(block.hidden_lattice->cellCount(), 12u);
	grid::validate(block);
}

// A curved cell is cut into parts on reading. All of them go, if one has such a node; and so does a cell that a
// tolerance refines.
TEST(PlacedCells, CurvedCellsGoWhole)
{
	const TemporaryFolder folder;
	const auto grid = curvedMesh({"", VTK_QUADRATIC_HEXAHEDRON, 20});
	std::array<double, 3> place;
	vtkIdType middle = 0; // middle of an edge of the box; only one cell has it
	for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
		if (grid->GetPoint(p, place.data()); place[0] == 0.0 && place[1] == 0.0 && place[2] == kCurvedBox.z / 4.0)
			middle = p;
	ASSERT_GT(middle, 0);
	grid->GetPoints()->SetPoint(middle, kNan, 0.0, 0.0);
	writeGrid(grid, folder / "a.vtu");
	for (const double refine : {0.0, 2.0, 0.01})
	{
		const Reading reading = readOf(folder / "a.vtu", refine);
		ASSERT_TRUE(reading.set) << reading.set.error().message;
		EXPECT_TRUE(tells(reading, ": 1 cell is left out")) << reading.words;
		EXPECT_EQ(reading.set->sourceCellCount(), 7u) << refine;
		expectBox(*reading.set, {0, 0, 0}, kCurvedBox);
	}
}

TEST(PlacedCells, ConvexPointSetsAndPrisms)
{
	const TemporaryFolder folder;
	const auto grid = rowOfCubes(2, -1, {});
	std::array<vtkIdType, 12> ids{};
	for (vtkIdType i = 0; i < 4; ++i)
		ids[static_cast<std::size_t>(i)] = i + 8;
	ids[4] = 12; // the point without a place
	grid->InsertNextCell(VTK_CONVEX_POINT_SET, 5, ids.data());
	for (std::size_t i = 0; i < 12; ++i)
		ids[i] = static_cast<vtkIdType>(i + 1);
	grid->InsertNextCell(VTK_HEXAGONAL_PRISM, 12, ids.data());
	writeGrid(grid, folder / "a.vtu");
	const Reading reading = readOf(folder / "a.vtu");
	ASSERT_TRUE(reading.set) << reading.set.error().message;
	EXPECT_TRUE(tells(reading, ": 2 cells are left out")) << reading.words;
	EXPECT_EQ(reading.set->cellCount(), 2u);
}
