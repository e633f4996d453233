// Cells of all shapes refined to a tolerance where a sheet meets them, side by side in one block.
#include "cut/cutter.h"
#include "mesh/mesh_values.h"
#include "mixed_cube.h"
#include "refined_section.h"
#include "sliced_sheet.h"
#include "surface/implicit_surface.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <numbers>

namespace vp::test
{

namespace
{

const std::vector<Vec3> kDirections{{0.3, 0.5, 0.8}, {1, 0.02, 0.03}, {-0.4, 1, 0.7}, {0, 0, 1}};

double farthest(const Vec3& p)
{
	return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// Edges of one polygon alone that do not lie on the cube's boundary.
std::size_t gapsIn(const mesh::SheetMesh& mesh)
{
	const std::vector<Vec3> open = openEdges(mesh);
	return static_cast<std::size_t>(
	    std::ranges::count_if(open, [](const Vec3& at) { return std::abs(farthest(at) - 1.0) > 1e-9; }));
}

} // namespace

TEST(RefinedShapes, AreasOfABallComeClose)
{
	expectAreasOfABall([](double tolerance) { return setOf(mixedCube(12, tolerance, ball)); }, 0.5);
}

TEST(RefinedShapes, SectionsAreClosedBetweenThem)
{
	const auto value = [](Vec3 p) { return std::sin(3.0 * p.x + p.y) + p.z * p.z; };
	for (const MixedCube::Choice& choice : {MixedCube::Choice{}, {true, false}, {false, true}})
	{
		const grid::BlockSet set = setOf(mixedCube(5, 0.003, bulge, value, choice));
		cut::Cutter cutter(set);
		for (const Vec3& normal : kDirections)
			for (const double distance : {0.05, 0.21, 0.4})
			{
				const Section cut = section(cutter, distance * glm::normalize(normal), normal, true);
				EXPECT_EQ(gapsIn(cut.mesh), 0u)
				    << distance << (choice.full ? " full" : "") << (choice.linear ? " linear" : "");
				EXPECT_GT(cut.mesh.polygons(), 500u);
			}
	}
}

// Values alone may have cells refined: then the area is exact, and so it shows a gap.
TEST(RefinedShapes, AreasAreExactWhereValuesAloneAreCurved)
{
	const auto peak = [](Vec3 p) { return std::exp(-8.0 * glm::dot(p, p)); };
	for (const MixedCube::Choice& choice : {MixedCube::Choice{}, {true, true}})
	{
		const grid::BlockSet set = setOf(mixedCube(6, 0.004, still, peak, choice));
		cut::Cutter cutter(set);
		for (const double at : {0.0, 1.0 / 3.0, 0.1234, -0.77, 1.0, -1.0})
		{
			const Section cut = section(cutter, Vec3(0, 0, at), Vec3(0, 0, 1), true);
			EXPECT_NEAR(cut.figures.area + cut.figures.boundary_area, 4.0, 1e-12) << at;
			for (const Vec3& open : openEdges(cut.mesh))
				EXPECT_NEAR(std::max(std::abs(open.x), std::abs(open.y)), 1.0, 1e-12);
		}
	}
}

TEST(RefinedShapes, ValuesKeepToTheTolerance)
{
	const auto square = [](Vec3 p) { return 1.0 + p.x * p.x - 2.0 * p.y * p.z + p.z; };
	const auto plane = [](Vec3 p) { return 1.0 + p.x - 2.0 * p.y + p.z; };
	const auto worstOf = [](const Value& value, double tolerance)
	{
		const grid::BlockSet set = setOf(mixedCube(3, tolerance, still, value));
		cut::Cutter cutter(set);
		const Section cut = section(cutter, Vec3(0.05, 0.02, 0.01), Vec3(0.3, 0.5, 0.8), true);
		const grid::FieldChoice field{"f"};
		const auto values = mesh::vertexValues(cut.blocks(), cut.mesh, field.inEach(cut.blocks()), 0);
		double worst = 0.0;
		for (std::size_t v = 0; v < values.size(); ++v)
			worst = std::max(worst, std::abs(values[v] - value(cut.mesh.positions[v])));
		return worst;
	};
	double before = 1e9;
	for (const double tolerance : {0.02, 0.004, 0.0008})
	{
		EXPECT_LE(worstOf(plane, tolerance), 1e-13);
		const double worst = worstOf(square, tolerance);
		EXPECT_LE(worst, tolerance * 9.0);
		EXPECT_LT(worst, before);
		before = worst;
	}
}

TEST(RefinedShapes, CellsThatTheSheetMissesAreLeftAlone)
{
	const grid::BlockSet set = setOf(mixedCube(12, 0.001, ball));
	cut::Cutter cutter(set);
	for (const Vec3& normal : kDirections)
	{
		const Section cut = section(cutter, 0.4 * glm::normalize(normal), normal);
		EXPECT_LT(cut.cut.refined_counts.looked_at, 0.6 * double(set.cellCount()));
		EXPECT_LT(cut.cut.refined_counts.cells, set.cellCount() / 4);
		EXPECT_EQ(cut.cut.refined_counts.parts, cut.blocks().cellCount());
		EXPECT_GE(cut.cut.sheets[0].cuts[0].cutCells() + 10, cut.blocks().cellCount() / 2);
	}
}

TEST(RefinedShapes, AreTheSameForAnyNumberOfThreads)
{
	const auto value = [](Vec3 p) { return std::sin(3.0 * p.x + p.y); };
	const grid::BlockSet set = setOf(mixedCube(8, 0.002, ball, value));
	std::vector<Section> made;
	for (const std::size_t threads : {1, 2, 7})
	{
		const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
		cut::Cutter cutter(set);
		made.push_back(section(cutter, Vec3(0.05, 0.02, 0.01), Vec3(0.3, 0.5, 0.8), true));
	}
	for (const Section& other : made)
	{
		ASSERT_EQ(other.mesh.positions.size(), made[0].mesh.positions.size());
		EXPECT_TRUE(std::ranges::equal(other.mesh.positions, made[0].mesh.positions));
		EXPECT_EQ(other.blocks().blocks[0].fields[0].value(1000, 0),
		          made[0].blocks().blocks[0].fields[0].value(1000, 0));
	}
}

// Spheres and an expression in a ball of curved cells, against formulas.
TEST(RefinedShapes, SurfacesThatAreNoPlanesAreCutToo)
{
	for (const double tolerance : {0.05, 0.001})
		for (const bool only_tetrahedra : {true, false})
		{
			const grid::BlockSet set =
			    setOf(only_tetrahedra ? quadraticCube(10, tolerance, ball) : mixedCube(10, tolerance, ball));
			cut::Cutter cutter(set);
			cut::CutRequest request;
			probe::Sheet sheet = probe::makeSheet(Vec3(0.0), Vec3(0, 0, 1));
			sheet.form = std::move(surface::ImplicitSurface::parse("x*x + y*y - 0.25").value());
			request.probe.sheets = {sheet};
			const cut::Cut cut = std::move(cutter.cut(request).value());
			const mesh::SheetMesh mesh = cut.mesh(set, 0);
			// The surface of the cylinder within the ball; cells of 1/5 make it of flat polygons.
			const double area = measure::measure(*cut.refined, mesh, {}).area;
			EXPECT_NEAR(area, 2.0 * std::numbers::pi * 0.5 * std::sqrt(3.0), 0.02 * area);
			for (const Vec3& at : openEdges(mesh))
				EXPECT_NEAR(glm::length(at), 1.0, 0.02);
			EXPECT_LT(cut.refined_counts.cells, set.cellCount() / 2);
			for (const Vec3& at : mesh.positions)
				ASSERT_NEAR(at.x * at.x + at.y * at.y, 0.25, 1e-9);
		}
}

} // namespace vp::test
