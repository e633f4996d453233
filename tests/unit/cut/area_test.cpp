#include "sliced_sheet.h"
#include "test_grids.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

// Returns the area of a box's section by a plane n.x = d with no zero in n: the second differences of the simplex
// volumes that are cut off at each corner.
double boxSection(const Box& box, const TestPlane& plane)
{
	Vec3 n = glm::normalize(plane.normal);
	double d = glm::dot(n, plane.origin - box.lo);
	for (int axis = 0; axis < 3; ++axis)
		if (n[axis] < 0.0) // mirrored about the box's middle
		{
			d -= n[axis] * box.size()[axis];
			n[axis] = -n[axis];
		}
	double sum = 0.0;
	for (int corner = 0; corner < 8; ++corner)
	{
		double beyond = d;
		double sign = 1.0;
		for (int axis = 0; axis < 3; ++axis)
			if (corner >> axis & 1)
			{
				beyond -= n[axis] * box.size()[axis];
				sign = -sign;
			}
		sum += sign * std::pow(std::max(0.0, beyond), 2);
	}
	return sum / (2.0 * n.x * n.y * n.z);
}

grid::Block cube(int n)
{
	return explicitHexahedra(n, [](int, int, int) { return true; });
}

std::vector<grid::Block> boxes()
{
	return {gridNamed("blob"), gridNamed("graded"), gridNamed("mixed"), gridNamed("inverted"), cube(5)};
}

// Returns the area of everything that is shown: the cut, and boundary faces in the plane.
double areaOf(cut::Cutter& cutter, const TestPlane& plane)
{
	const SlicedSheet sheet = cut(cutter, plane);
	for (const Vec3& p : sheet.mesh.positions)
		EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
	const measure::SheetMeasure measure = measure::measure(cutter.blocks(), sheet.mesh, {});
	return measure.area + measure.boundary_area;
}

Vec3 axis(int a)
{
	Vec3 direction(0.0);
	direction[a] = 1.0;
	return direction;
}

double sideArea(const Box& box, int a)
{
	return box.size()[(a + 1) % 3] * box.size()[(a + 2) % 3];
}

} // namespace

TEST(Area, OfABoxIsTheFormulas)
{
	for (const grid::Block& block : boxes())
	{
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (const TestPlane& plane : randomPlanes(block.bounds, 100, 40))
		{
			const Vec3 n = glm::abs(plane.normal);
			if (std::min({n.x, n.y, n.z}) < 0.01)
				continue; // the formula loses digits
			EXPECT_NEAR(areaOf(cutter, plane), boxSection(block.bounds, plane), 1e-10 * sideArea(block.bounds, 0))
			    << block.name;
		}
	}
}

TEST(Area, OfPlanesThroughLayersOfVerticesIsWhole)
{
	for (const grid::Block& block : boxes())
	{
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (int a = 0; a < 3; ++a)
			for (CellId c = 0; c < cellCount(block); c += 7)
				for (const Vec3& corner : cellCorners(block, c))
					for (const double sign : {1.0, -1.0})
						ASSERT_NEAR(areaOf(cutter, {corner, sign * axis(a)}), sideArea(block.bounds, a),
						            1e-12 * sideArea(block.bounds, a))
						    << block.name << ", axis " << a << ", at " << corner[a];
	}
}

TEST(Area, OnTheSidesOfTheDomainIsShownOnce)
{
	for (const grid::Block& block : boxes())
	{
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (int a = 0; a < 3; ++a)
			for (const Vec3& origin : {block.bounds.lo, block.bounds.hi})
			{
				EXPECT_NEAR(areaOf(cutter, {origin, axis(a)}), sideArea(block.bounds, a),
				            1e-12 * sideArea(block.bounds, a))
				    << block.name;
				const Vec3 beside = origin + (origin - block.bounds.center()) * 1e-9;
				EXPECT_EQ(areaOf(cutter, {beside, axis(a)}), 0.0) << block.name;
			}
	}
}

// Cells left and right of a plane that meet in an edge only: the tie rule cuts those on the negative side, and the
// faces of the others have an area of their own.
TEST(Area, OfBoundaryFacesIsToldApart)
{
	const grid::BlockSet set = setOf(explicitHexahedra(2, [](int i, int j, int) { return i == j; }));
	cut::Cutter cutter(set);
	const SlicedSheet sheet = cut(cutter, {{0.5, 0.5, 0.5}, {1.0, 0.0, 0.0}});
	const measure::SheetMeasure measure = measure::measure(set, sheet.mesh, {});
	EXPECT_EQ(sheet.mesh.boundary_polygons, 2u);
	EXPECT_EQ(sheet.mesh.polygons(), 4u);
	EXPECT_EQ(sheet.cutCellCount(), 2u);
	EXPECT_DOUBLE_EQ(measure.area, 0.5);
	EXPECT_DOUBLE_EQ(measure.boundary_area, 0.5);
}

TEST(Area, OfPlanesAlongDiagonals)
{
	const grid::Block block = cube(4);
	const grid::BlockSet set = setOf(block);
	cut::Cutter cutter(set);
	EXPECT_NEAR(areaOf(cutter, {{0.0, 0.0, 0.0}, {1.0, -1.0, 0.0}}), std::sqrt(2.0), 1e-14);
	EXPECT_NEAR(areaOf(cutter, {{0.25, 0.0, 0.0}, {1.0, -1.0, 0.0}}), 0.75 * std::sqrt(2.0), 1e-14);
	EXPECT_NEAR(areaOf(cutter, {{0.5, 0.5, 0.5}, {1.0, 1.0, 1.0}}), 0.75 * std::sqrt(3.0),
	            1e-14); // the regular hexagon
	EXPECT_NEAR(areaOf(cutter, {{1.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}), 0.5 * std::sqrt(3.0), 1e-14);
	EXPECT_NEAR(areaOf(cutter, {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}), 0.0, 1e-14); // touches a corner
	EXPECT_NEAR(areaOf(cutter, {{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}}), 0.0, 1e-14); // touches an edge
}

TEST(Area, FarAwayAndTinyDomainsLoseNothing)
{
	for (const double offset : {0.0, 1e7})
		for (const double size : {1e-6, 1.0, 1e6})
		{
			grid::Block block;
			block.grid = grid::UniformGrid({9, 9, 9}, Vec3(offset), Vec3(size / 8.0));
			grid::finishBlock(block);
			const grid::BlockSet set = setOf(block);
			cut::Cutter cutter(set);
			const TestPlane plane{block.bounds.center(), {0.3, 0.5, 0.81}};
			// The last bit of a coordinate, as the domain sees it.
			const double rounding = 1e-15 * (offset + size) / size;
			EXPECT_NEAR(areaOf(cutter, plane) / (size * size),
			            boxSection({Vec3(0.0), Vec3(1.0)}, {Vec3(0.5), plane.normal}), 100.0 * rounding);
		}
}

} // namespace vp::test
