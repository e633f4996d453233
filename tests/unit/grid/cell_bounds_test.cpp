#include "grid/block.h"
#include "grid/link/cell_bounds.h"
#include "grid/link/cell_order.h"
#include "grid/link/face_corners.h"
#include "grid/unstructured.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vp::grid
{
namespace
{

// A point that no cell uses lies beyond one side of the cells.
TEST(CellBounds, AreThoseOfPointsOfCells)
{
	for (int side = 0; side < 6; ++side)
	{
		SCOPED_TRACE(side);
		test::CellListMaker maker;
		for (const Vec3& p : {Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 2.0, 0.0), Vec3(0.0, 0.0, 3.0)})
			maker.point(p);
		Vec3 beyond(0.5);
		beyond[side / 2] = side % 2 ? 9.0 : -9.0;
		maker.point(beyond);
		maker.cell(10, {0, 1, 2, 3});
		const Box bounds = boundsOfCells(maker.points(), maker.list());
		EXPECT_EQ(bounds.lo, Vec3(0.0));
		EXPECT_EQ(bounds.hi, Vec3(1.0, 2.0, 3.0));
	}
}

// Bounds are asked for before any grid is built, so these ids are the first that are looked at.
TEST(CellBounds, RefuseIdsOfNoPoint)
{
	test::CellListMaker maker;
	for (const Vec3& p : {Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 2.0, 0.0), Vec3(0.0, 0.0, 3.0), Vec3(9.0)})
		maker.point(p);
	maker.cell(10, {0, 1, 2, 3});
	maker.cell(10, {0, 1, 2, 77'000'000});
	CellList cells = maker.list();
	cells.offsets = {};
	cells.has_checked_ids = false;
	EXPECT_THROW(boundsOfCells(maker.points(), cells), WrongPoint);
}

// So many that several threads count, each a part.
TEST(CellCounts, CountEveryType)
{
	std::vector<std::uint8_t> types;
	for (int i = 0; i < 1'000'000; ++i)
		types.insert(types.end(), {0, 10, 5, 12});
	CellList cells;
	cells.types = types;
	const CellCounts counts = countCells(Points(), cells);
	EXPECT_EQ(counts.kept, 2'000'000u);
	EXPECT_EQ(counts.left_out, 2'000'000u); // empty cells are points without a place, as triangles are flat
	EXPECT_EQ(counts.tetrahedra, 1'000'000u);
	EXPECT_FALSE(counts.alike);
}

TEST(CellCounts, CellsOfOneTableAreAlike)
{
	const auto areAlike = [](std::vector<std::uint8_t> types)
	{
		CellList cells;
		cells.types = std::move(types);
		return countCells(Points(), cells).alike;
	};
	EXPECT_TRUE(areAlike({10}));
	EXPECT_TRUE(areAlike({12, 12}));
	EXPECT_FALSE(areAlike({12, 10}));
	EXPECT_FALSE(areAlike({5, 5})); // flat
	EXPECT_FALSE(areAlike({42}));   // polyhedra have no table
	EXPECT_FALSE(areAlike({}));
}

// One that has shrunk to a point is still somewhere.
TEST(FaceCorners, AFaceWithoutSizeKeepsOne)
{
	test::CellListMaker maker;
	for (const Vec3& p : {Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(1.0, 1.0, 0.0), Vec3(0.0, 1.0, 0.0)})
		maker.point(p);
	for (int i = 0; i < 4; ++i)
		maker.point(Vec3(0.5, 0.5, 1.0));
	maker.cell(12, {0, 1, 2, 3, 4, 5, 6, 7});
	const UnstructuredGrid grid = UnstructuredGrid::build(maker.points(), maker.list());
	CellFaces faces;
	std::vector<Vec3> corners;
	std::vector<std::size_t> sizes;
	for (std::uint32_t face = 0; face < 6; ++face)
	{
		faceCorners(grid, {0, face}, faces, corners);
		sizes.push_back(corners.size());
	}
	std::ranges::sort(sizes);
	EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 3, 3, 3, 3, 4}));
}

} // namespace
} // namespace vp::grid
