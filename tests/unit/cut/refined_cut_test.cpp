// Quadratic tetrahedra refined to a tolerance where a sheet meets them: sections against formulas, closed between cells
// that are refined differently, and no work beside the sheet.
#include "cut/cutter.h"
#include "grid/curved/curved_cells.h"
#include "measure/stats.h"
#include "mesh/mesh_values.h"
#include "quadratic_cube.h"
#include "refined_section.h"
#include "sliced_sheet.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>

namespace vp::test
{

namespace
{

const std::vector<Vec3> kNormals{{0.3, 0.5, 0.8}, {1, 0.02, 0.03}, {-0.4, 1, 0.7}, {0, 0, 1}};

} // namespace

TEST(RefinedCut, AreasOfABallComeClose)
{
	expectAreasOfABall([](double tolerance) { return setOf(quadraticCube(12, tolerance, ball)); }, 0.3);
}

TEST(RefinedCut, SectionsAreClosedBetweenCellsThatAreRefinedDifferently)
{
	const grid::BlockSet set = setOf(quadraticCube(7, 0.002, bulge));
	cut::Cutter cutter(set);
	for (const Vec3& normal : kNormals)
		for (const double distance : {0.0, 0.05, 0.21, 2.0 / 7.0, 0.4})
		{
			const Section cut = section(cutter, distance * glm::normalize(normal), normal);
			std::map<std::size_t, int> parts;
			const auto& grid = std::get<grid::UnstructuredGrid>(cut.blocks().blocks[0].grid);
			for (CellId c = 0; c < grid.cellCount(); ++c)
				++parts[grid.sourceCell(c)];
			int most = 0;
			int least = 1000000;
			for (const auto& [cell, count] : parts)
			{
				most = std::max(most, count);
				least = std::min(least, count);
			}
			EXPECT_EQ(least, 1);
			EXPECT_GT(most, 8);
			for (const Vec3& at : openEdges(cut.mesh))
				EXPECT_NEAR(std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}), 1.0, 1e-9);
			// A plane through nodes passes some of them by rounding, with vertices beside each other.
			if (distance == 0.05 || distance == 0.21 || distance == 0.4)
			{
				EXPECT_EQ(cut.figures.components, 1u);
			}
		}
}

// Values alone may have cells refined: then the area is exact, and so it shows a gap.
TEST(RefinedCut, AreasAreExactWhereValuesAloneAreCurved)
{
	const auto peak = [](Vec3 p) { return std::exp(-8.0 * glm::dot(p, p)); };
	const grid::BlockSet set = setOf(quadraticCube(6, 0.002, still, peak));
	cut::Cutter cutter(set);
	for (const double at : {0.0, 1.0 / 3.0, 0.1234, -0.77, 1.0, -1.0})
	{
		const Section cut = section(cutter, Vec3(0, 0, at), Vec3(0, 0, 1), true);
		EXPECT_NEAR(cut.figures.area + cut.figures.boundary_area, 4.0, 1e-12) << at;
		for (const Vec3& open : openEdges(cut.mesh))
			EXPECT_NEAR(std::max(std::abs(open.x), std::abs(open.y)), 1.0, 1e-12);
	}
	EXPECT_GT(section(cutter, Vec3(0.0), Vec3(0, 0, 1), true).mesh.polygons(),
	          4 * section(cutter, Vec3(0.0), Vec3(0, 0, 1)).mesh.polygons());
}

// The shape functions hold a quadratic field, so only the parts are off.
TEST(RefinedCut, ValuesKeepToTheTolerance)
{
	const auto value = [](Vec3 p) { return 1.0 + p.x * p.x - 2.0 * p.y * p.z + p.z; };
	const auto [lo, hi] = std::pair{-3.0, 6.0};
	double before = 1e9;
	for (const double tolerance : {0.02, 0.004, 0.0008})
	{
		const grid::BlockSet set = setOf(quadraticCube(3, tolerance, still, value));
		cut::Cutter cutter(set);
		const Section cut = section(cutter, Vec3(0.05, 0.02, 0.01), Vec3(0.3, 0.5, 0.8), true);
		const grid::FieldChoice field{"f"};
		const auto values = mesh::vertexValues(cut.blocks(), cut.mesh, field.inEach(cut.blocks()), 0);
		double worst = 0.0;
		for (std::size_t v = 0; v < values.size(); ++v)
			worst = std::max(worst, std::abs(values[v] - value(cut.mesh.positions[v])));
		EXPECT_LE(worst, tolerance * (hi - lo));
		EXPECT_LT(worst, before);
		before = worst;
	}
}

// A cell that bulges beyond its corners: a node in the middle of an edge reaches to z = 1.2.
TEST(RefinedCut, BoundsHoldNodesBetweenCorners)
{
	const grid::Block block = quadraticCube(
	    1, 0.002, [](Vec3 p) { return p + Vec3(0.0, 0.0, 0.2 * p.z * (1.0 - p.x * p.x) * (1.0 - p.y * p.y)); });
	EXPECT_EQ(block.bounds.hi, Vec3(1.0, 1.0, 1.2));
	EXPECT_EQ(block.bounds.lo, Vec3(-1.0, -1.0, -1.2));
}

// A vector's components are off together, as its length would be. Other arrays come along, integers rounded.
TEST(RefinedCut, VectorsKeepToTheTolerance)
{
	grid::Block block = quadraticCube(3, 0.002, still);
	const grid::Points& points = block.curved->points;
	for (const int components : {3, 9, 10})
	{
		std::vector<float> values;
		for (std::size_t p = 0; p < points.size(); ++p)
			for (int c = 0; c < components; ++c)
				values.push_back(static_cast<float>(c == 0 ? 2.0 * points[p].x * points[p].x : points[p].y));
		block.fields.push_back(
		    grid::makeField("v" + std::to_string(components), grid::Association::point, components, std::move(values)));
	}
	std::vector<std::uint64_t> numbers(points.size(), std::numeric_limits<std::uint64_t>::max());
	block.fields.push_back(grid::makeField("n", grid::Association::point, 1, std::move(numbers)));
	const grid::BlockSet set = setOf(block);
	cut::Cutter cutter(set);
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(Vec3(0.05, 0.02, 0.01), Vec3(0.3, 0.5, 0.8))};
	for (const int components : {3, 9})
	{
		request.field = grid::FieldChoice{"v" + std::to_string(components), grid::Association::point, grid::kMagnitude};
		const cut::Cut cut = std::move(cutter.cut(request).value());
		const mesh::SheetMesh mesh = cut.mesh(set, 0);
		const auto [lo, hi] = grid::fieldRange(set, *request.field);
		const auto first = mesh::vertexValues(*cut.refined, mesh, request.field->inEach(*cut.refined), 0);
		double worst = 0.0;
		for (std::size_t v = 0; v < mesh.positions.size(); ++v)
			worst = std::max(worst, std::abs(first[v] - 2.0 * mesh.positions[v].x * mesh.positions[v].x));
		EXPECT_LE(worst, 0.002 * (hi - lo) + 1e-6) << components;
		EXPECT_GT(worst, 0.0002 * (hi - lo)) << components;
		const grid::Field& n = cut.refined->blocks[0].fields.back();
		ASSERT_EQ(n.name, "n");
		ASSERT_EQ(n.type, grid::NumberType::uint64);
		EXPECT_GT(n.value(n.tuples() - 1, 0), 1e19);
	}
	request.field = grid::FieldChoice{"v10", grid::Association::point, grid::kMagnitude};
	const Result<cut::Cut> refused = cutter.cut(request);
	ASSERT_FALSE(refused);
	EXPECT_NE(refused.error().message.find("9 numbers of a point at most"), std::string::npos);
	request.field->component = 7;
	EXPECT_TRUE(cutter.cut(request));
}

TEST(RefinedCut, CellsThatTheSheetMissesAreLeftAlone)
{
	const grid::BlockSet set = setOf(quadraticCube(12, 0.001, ball));
	const grid::CurvedCells& curved = *set.blocks[0].curved;
	cut::Cutter cutter(set);
	for (const Vec3& normal : kNormals)
	{
		const Vec3 origin = 0.4 * glm::normalize(normal);
		const Section cut = section(cutter, origin, normal);
		// The cells with control points on both sides are cut, and no others.
		const surface::Plane plane(origin, normal);
		std::size_t met = 0;
		for (std::size_t c = 0; c < curved.cells.size(); ++c)
		{
			constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
			std::array<double, 10> height;
			for (std::size_t n = 0; n < 10; ++n)
				height[n] = plane.signedDistance(
				    curved.points[static_cast<std::size_t>(curved.cells.connectivity[10 * c + n])]);
			for (std::size_t e = 0; e < 6; ++e)
				height[4 + e] = 2.0 * height[4 + e] - 0.5 * (height[edges[e][0]] + height[edges[e][1]]);
			met += *std::ranges::min_element(height) <= 1e-12 && *std::ranges::max_element(height) >= -1e-12;
		}
		EXPECT_EQ(cut.cut.refined_counts.cells, met);
		EXPECT_LT(cut.cut.refined_counts.looked_at, curved.cells.size() / 2);
		EXPECT_LT(met, curved.cells.size() / 4);
		EXPECT_EQ(cut.cut.refined_counts.parts, cut.blocks().cellCount());
		// Every part is cut, or touches the plane.
		EXPECT_GE(cut.cut.sheets[0].cuts[0].cutCells() + 10, cut.blocks().cellCount() / 2);
	}
}

TEST(RefinedCut, SeveralSheetsAreCutAsEachAlone)
{
	const grid::BlockSet set = setOf(quadraticCube(5, 0.003, ball));
	cut::Cutter cutter(set);
	cut::CutRequest request;
	for (const Vec3& normal : kNormals)
		request.probe.sheets.push_back(probe::makeSheet(0.2 * normal, normal));
	const cut::Cut all = std::move(cutter.cut(request).value());
	for (std::size_t s = 0; s < kNormals.size(); ++s)
	{
		const mesh::SheetMesh mesh = all.mesh(set, s);
		const Section alone = section(cutter, 0.2 * kNormals[s], kNormals[s]);
		EXPECT_EQ(mesh.polygons(), alone.mesh.polygons());
		EXPECT_NEAR(measure::measure(*all.refined, mesh, {}).area, alone.figures.area, 1e-12);
	}
}

TEST(RefinedCut, LinearCellsMayStandAmongThem)
{
	// Straight cells: every second one is listed without the nodes on its edges.
	grid::Block block = quadraticCube(4, 0.01, still);
	const grid::CurvedCells& given = *block.curved;
	grid::CurvedCells mixed;
	mixed.points = given.points;
	mixed.tolerance = given.tolerance;
	std::vector<std::uint8_t> types;
	std::vector<std::int64_t> offsets{0};
	std::vector<std::int32_t> nodes;
	for (std::size_t c = 0; c < given.cells.size(); ++c)
	{
		types.push_back(c % 2 ? grid::kTetra : grid::kLagrangeTetra);
		for (std::size_t n = 0; n < (c % 2 ? 4 : 10); ++n)
			nodes.push_back(static_cast<std::int32_t>(given.cells.connectivity[10 * c + n]));
		offsets.push_back(static_cast<std::int64_t>(nodes.size()));
	}
	mixed.cells.types = std::move(types);
	mixed.cells.offsets = std::move(offsets);
	mixed.cells.connectivity = std::move(nodes);
	grid::Block of_both;
	takeCurvedCells(of_both, std::move(mixed));
	const grid::BlockSet set = setOf(std::move(of_both));
	cut::Cutter cutter(set);
	for (const double at : {0.0, 0.5, 0.3})
		EXPECT_NEAR(section(cutter, Vec3(0, 0, at), Vec3(0, 0, 1)).figures.area, 4.0, 1e-12);
}

TEST(RefinedCut, NodesAnywhereGiveAnEndAndNoGap)
{
	std::mt19937 random(7);
	std::uniform_real_distribution<double> shift(-0.15, 0.15);
	const Map shaken = [&](Vec3 p)
	{
		for (int axis = 0; axis < 3; ++axis)
			if (std::abs(p[axis]) < 0.999)
				p[axis] += shift(random);
		return p;
	};
	const grid::BlockSet set = setOf(quadraticCube(2, 0.01, shaken));
	cut::Cutter cutter(set);
	for (const Vec3& normal : kNormals)
		for (const Vec3& at : openEdges(section(cutter, Vec3(0.03, 0.01, 0.02), normal).mesh))
			EXPECT_NEAR(std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}), 1.0, 1e-9);
	const double nan = std::numeric_limits<double>::quiet_NaN();
	const grid::BlockSet bare = setOf(quadraticCube(2, 0.01, ball, [&](Vec3 p) { return p.x > 0.2 ? nan : p.x; }));
	cut::Cutter bare_cutter(bare);
	const Section cut = section(bare_cutter, Vec3(0.0), Vec3(0, 0, 1), true);
	EXPECT_GT(cut.figures.nan_area, 0.5);
	EXPECT_GT(cut.figures.area, 3.0);
}

TEST(RefinedCut, SaysWhatNeedsLinearCells)
{
	const grid::BlockSet set = setOf(quadraticCube(2, 0.01, ball, [](Vec3 p) { return p.x; }));
	cut::Cutter cutter(set);
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(Vec3(0.0), Vec3(0, 0, 1))};
	request.field = grid::FieldChoice{"f"};
	const auto refused = [&](const cut::CutRequest& of, const char* what)
	{
		const Result<cut::Cut> cut = cutter.cut(of);
		ASSERT_FALSE(cut) << what;
		EXPECT_EQ(cut.error().message.find(what), 0u) << cut.error().message;
		EXPECT_NE(cut.error().message.find("with `refine` 1"), std::string::npos);
	};
	EXPECT_TRUE(cutter.cut(request));
	cut::CutRequest of = request;
	of.threshold = find::Threshold{0.0, 1.0};
	refused(of, "a threshold");
	of = request;
	of.strategy = find::Strategy::cells;
	refused(of, "cells");
	of = request;
	of.seeds.mode = seed::SeedMode::hotspot;
	refused(of, "seeds");
	EXPECT_TRUE(cutter.plan(request));
	EXPECT_FALSE(cutter.plan(request)->needs_neighbors);
}

} // namespace vp::test
