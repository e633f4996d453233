#include "grid/measure.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace vp::grid
{
namespace
{

constexpr CellShape kShapes[] = {CellShape::tetrahedron, CellShape::pyramid, CellShape::wedge, CellShape::hexahedron};

TEST(CellShape, IsAClosedSurface)
{
	for (const CellShape shape : kShapes)
	{
		const ShapeTopology& table = topology(shape);
		EXPECT_EQ(table.points - table.edges + table.faces, 2) << shapeName(shape);
		// Every edge is run through once each way: closed, and all faces turned alike.
		std::map<std::pair<int, int>, int> runs;
		for (int f = 0; f < table.faces; ++f)
		{
			const auto face = table.facePoints(f);
			for (std::size_t i = 0; i < face.size(); ++i)
				++runs[{face[i], face[(i + 1) % face.size()]}];
		}
		EXPECT_EQ(runs.size(), 2u * table.edges) << shapeName(shape);
		for (const auto& [run, count] : runs)
		{
			EXPECT_EQ(count, 1) << shapeName(shape);
			EXPECT_TRUE(runs.contains({run.second, run.first})) << shapeName(shape);
			EXPECT_GE(table.edgeBetween(run.first, run.second), 0) << shapeName(shape);
		}
		EXPECT_EQ(table.edgeBetween(0, 0), -1);
	}
	EXPECT_EQ(topology(CellShape::hexahedron).edgeBetween(0, 6), -1);
}

// VTK's reference cells; the wedge's first triangle faces down.
TEST(CellShape, VolumesArePositive)
{
	test::CellListMaker maker;
	const Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
	for (const Vec3& p : corners)
		maker.point(p);
	maker.cell(10, {0, 1, 3, 4});
	maker.cell(14, {0, 1, 2, 3, 4});
	maker.cell(13, {0, 3, 1, 4, 7, 5});
	maker.cell(12, {0, 1, 2, 3, 4, 5, 6, 7});
	maker.cell(11, {0, 1, 3, 2, 4, 5, 7, 6});
	maker.polyhedron({{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}});
	maker.cell(12, {4, 5, 6, 7, 0, 1, 2, 3});
	const Block block = maker.block("shapes");
	const auto& grid = std::get<UnstructuredGrid>(block.grid);
	const double expected[] = {1.0 / 6.0, 1.0 / 3.0, 0.5, 1.0, 1.0, 1.0, -1.0};
	CellFaces faces;
	for (CellId c = 0; c < grid.cellCount(); ++c)
		EXPECT_NEAR(signedVolume(grid, c, faces), expected[grid.sourceCell(c)], 1e-12) << grid.sourceCell(c);
	std::set<std::size_t> inverted;
	for (const CellId c : block.inverted)
		inverted.insert(grid.sourceCell(c));
	// The cells overlap: all but the first have a face that three cells or more have, so two lie on one side of it.
	EXPECT_EQ(inverted, (std::set<std::size_t>{1, 2, 3, 4, 5, 6}));
}

TEST(CellShape, VtkTypes)
{
	int sliceable = 0;
	for (int type = 0; type < 256; ++type)
	{
		sliceable += isSliceable(static_cast<std::uint8_t>(type));
		EXPECT_TRUE(!isSliceable(static_cast<std::uint8_t>(type)) || vtkDimension(static_cast<std::uint8_t>(type)) == 3)
		    << type;
	}
	EXPECT_EQ(sliceable, 6);
	for (const int flat : {5, 6, 7, 8, 9, 22, 23, 28, 30, 34, 36, 69, 70, 76, 77})
		EXPECT_EQ(vtkDimension(static_cast<std::uint8_t>(flat)), 2) << flat;
	for (const int solid : {15, 16, 24, 25, 26, 27, 29, 31, 32, 33, 37, 41, 71, 72, 73, 74, 78, 79, 80, 81})
		EXPECT_EQ(vtkDimension(static_cast<std::uint8_t>(solid)), 3) << solid;
	EXPECT_EQ(vtkDimension(17), -1);
	EXPECT_EQ(vtkDimension(200), -1);
}

} // namespace
} // namespace vp::grid
