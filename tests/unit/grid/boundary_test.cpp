#include "grid/measure.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace vp::grid
{
namespace
{

double boundaryArea(const Block& block)
{
	double area = 0.0;
	std::visit(
	    [&](const auto& grid)
	    {
		    CellFaces faces;
		    for (const BoundaryIndex::Face& face : block.boundary.faces)
		    {
			    grid.cellFaces(face.cell, faces);
			    const auto points = faces[face.face];
			    area += glm::length(polygonArea(points.size(), [&](std::size_t i) { return grid.point(points[i]); }));
		    }
	    },
	    block.grid);
	return area;
}

TEST(Boundary, AreasOfBoxes)
{
	// The surface of the 6^3 box. The mixed grid shows no inner face only if all its shapes meet.
	EXPECT_NEAR(boundaryArea(test::gridNamed("blob")), 216.0, 1e-9);
	EXPECT_NEAR(boundaryArea(test::gridNamed("graded")), 216.0, 1e-9);
	EXPECT_NEAR(boundaryArea(test::gridNamed("mixed")), 216.0, 1e-5);
	EXPECT_NEAR(boundaryArea(test::gridNamed("u_shape")), 2 * 7.0 / 9.0 + 4 + 4.0 / 3.0, 1e-9);
	EXPECT_NEAR(boundaryArea(test::gridNamed("two_pieces")), 4 + 2 * 4.0 / 3.0, 1e-9);
	EXPECT_NEAR(boundaryArea(test::gridNamed("two_to_one")), 5 + 1 + 4 * 0.5, 1e-9);
}

TEST(Boundary, VisitsEachFaceOnceWhereEveryBoxMeets)
{
	for (const Block& block : test::allGrids())
	{
		std::set<std::pair<CellId, std::uint32_t>> seen;
		const std::size_t tests =
		    block.boundary.visitWhere([](const Box&) { return true; },
		                              [&](BoundaryIndex::Face face) {
			                              EXPECT_TRUE(seen.insert({face.cell, face.face}).second) << block.name;
		                              });
		EXPECT_EQ(seen.size(), block.boundary.faces.size()) << block.name;
		EXPECT_EQ(tests, block.boundary.groups.size() + block.boundary.patches.size()) << block.name;
	}
}

TEST(Boundary, FindsEveryFaceThatAPlaneCuts)
{
	for (const Block& block : test::allGrids())
		std::visit(
		    [&](const auto& grid)
		    {
			    const double level = block.bounds.center().z + 0.01;
			    std::set<std::pair<CellId, std::uint32_t>> found;
			    block.boundary.visitWhere([&](const Box& box) { return box.lo.z <= level && box.hi.z >= level; },
			                              [&](BoundaryIndex::Face face) {
				                              found.insert({face.cell, face.face});
			                              });
			    CellFaces faces;
			    for (const BoundaryIndex::Face& face : block.boundary.faces)
			    {
				    grid.cellFaces(face.cell, faces);
				    bool above = false;
				    bool below = false;
				    for (const PointId p : faces[face.face])
					    (grid.point(p).z >= level ? above : below) = true;
				    EXPECT_TRUE(!(above && below) || found.contains({face.cell, face.face})) << block.name;
			    }
		    },
		    block.grid);
}

TEST(Boundary, PatchesOfALatticeAreSquares)
{
	const UniformGrid grid({41, 38, 5}, Vec3(0.0), Vec3(1.0));
	const BoundaryIndex index = buildBoundaryIndex(grid);
	EXPECT_EQ(index.faces.size(), 2u * (40 * 37 + 40 * 4 + 37 * 4));
	// 2 x 2 groups on the sides along i and j, 2 on each of the others.
	EXPECT_EQ(index.groups.size(), 2u * (4 + 2 + 2));
	EXPECT_EQ(index.patches.size(), 2u * (10 * 10 + 10 + 10));
	for (const BoundaryIndex::Range& patch : index.patches)
		EXPECT_LE(patch.box.diagonal(), std::sqrt(32.0));
}

TEST(Boundary, DegenerateSideOfALatticeCounts)
{
	// The side on the axis has no area, yet it is listed.
	const Block& block = test::gridNamed("collapsed_axis");
	EXPECT_EQ(block.boundary.faces.size(), 2u * (3 * 5 + 3 * 3 + 5 * 3));
}

TEST(Boundary, EmptyGrids)
{
	EXPECT_TRUE(buildBoundaryIndex(UniformGrid({5, 1, 5}, Vec3(0.0), Vec3(1.0))).faces.empty());
	EXPECT_TRUE(buildBoundaryIndex(UnstructuredGrid()).faces.empty());
}

} // namespace
} // namespace vp::grid
