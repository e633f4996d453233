#include "mesh/mesh_values.h"
#include "sliced_sheet.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <limits>

namespace vp::test
{

namespace
{

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

// Points 0..2n-1 in pairs, so that vertex v of a mesh lies on the edge (2v, 2v + 1) and takes the value of point 2v at
// t = 0.
grid::BlockSet carrier(std::vector<double> values)
{
	grid::Block block;
	block.grid = grid::UniformGrid({static_cast<std::uint32_t>(2 * values.size()), 2, 2}, Vec3(0.0), Vec3(1.0));
	std::vector<double> s(8 * values.size(), 0.0);
	for (std::size_t v = 0; v < values.size(); ++v)
		s[2 * v] = values[v];
	block.fields.push_back(grid::makeField("s", grid::Association::point, 1, std::move(s)));
	grid::BlockSet set;
	set.blocks.push_back(std::move(block));
	return set;
}

mesh::SheetMesh polygonsOf(std::vector<Vec3> positions, std::vector<std::vector<std::uint32_t>> polygons)
{
	mesh::SheetMesh mesh;
	for (std::uint32_t v = 0; v < positions.size(); ++v)
		mesh.edges.push_back({0, 2 * v, 2 * v + 1, 0.0});
	mesh.positions.assign(positions.begin(), positions.end());
	mesh.polygon_starts.push_back(0);
	for (const std::vector<std::uint32_t>& polygon : polygons)
	{
		mesh.polygon_vertices.insert(mesh.polygon_vertices.end(), polygon.begin(), polygon.end());
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
		mesh.polygon_cells.push_back({0, static_cast<CellId>(mesh.polygon_cells.size())});
	}
	return mesh;
}

const grid::FieldChoice kOnPoints{"s", grid::Association::point, 0};
const grid::FieldChoice kOnCells{"c", grid::Association::cell, 0};

} // namespace

// A trapezium: its fan about (0.75, 0.5) has the areas 0.5, 0.375, 0.25 and 0.375.
TEST(Measure, APolygonIsAFanAboutItsMean)
{
	const grid::BlockSet set = carrier({1.0, 2.0, 4.0, 9.0});
	const mesh::SheetMesh mesh = polygonsOf({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
	const measure::SheetMeasure measure = measure::measure(set, mesh, kOnPoints);
	EXPECT_DOUBLE_EQ(measure.area, 1.5);
	const double integral =
	    0.5 * (1 + 2 + 4) / 3.0 + 0.375 * (2 + 4 + 4) / 3.0 + 0.25 * (4 + 9 + 4) / 3.0 + 0.375 * (9 + 1 + 4) / 3.0;
	EXPECT_DOUBLE_EQ(measure.mean.value(), integral / 1.5);
	EXPECT_EQ(measure.min, 1.0);
	EXPECT_EQ(measure.max, 9.0);
	EXPECT_EQ(measure.nan_area, 0.0);
	EXPECT_EQ(measure::nanArea(set, mesh, kOnPoints), measure.nan_area);
	EXPECT_EQ(measure.components, 1u);
}

// A dart: two triangles of its fan about the mean run the other way.
TEST(Measure, AConcavePolygonIsNoMoreThanItIs)
{
	const grid::BlockSet set = carrier({5.0, 0.0, 1.0, 0.0}); // 5 - x at the corners
	const mesh::SheetMesh mesh = polygonsOf({{0, 0, 0}, {5, -1, 0}, {4, 0, 0}, {5, 1, 0}}, {{0, 1, 2, 3}});
	const measure::SheetMeasure measure = measure::measure(set, mesh, kOnPoints);
	EXPECT_DOUBLE_EQ(measure.area, 4.0);
	EXPECT_DOUBLE_EQ(measure.mean.value(), 2.0); // at the centroid, x = 3
	EXPECT_DOUBLE_EQ(measure::measure(set, mesh, {}).area, 4.0);
}

TEST(Measure, NanStaysOutOfMeanAndRange)
{
	const grid::BlockSet set = carrier({1.0, 1.0, 3.0, kNoValue, 3.0, 3.0});
	const mesh::SheetMesh mesh =
	    polygonsOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {7, 0, 0}, {5, 2, 0}}, {{0, 1, 2}, {3, 4, 5}});
	const measure::SheetMeasure measure = measure::measure(set, mesh, kOnPoints);
	EXPECT_DOUBLE_EQ(measure.area, 2.5);
	EXPECT_DOUBLE_EQ(measure.nan_area, 2.0);
	EXPECT_EQ(measure::nanArea(set, mesh, kOnPoints), measure.nan_area);
	EXPECT_DOUBLE_EQ(measure.mean.value(), 5.0 / 3.0);
	EXPECT_EQ(measure.min, 1.0);
	EXPECT_EQ(measure.max, 3.0);
	EXPECT_EQ(measure.components, 2u);
}

TEST(Measure, AllNanHasNoMean)
{
	const grid::BlockSet set = carrier({kNoValue, kNoValue, kNoValue});
	const measure::SheetMeasure measure =
	    measure::measure(set, polygonsOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), kOnPoints);
	EXPECT_DOUBLE_EQ(measure.nan_area, 0.5);
	EXPECT_FALSE(measure.mean || measure.min || measure.max);
}

TEST(Measure, NoArrayAndNoPolygons)
{
	const grid::BlockSet set = carrier({1.0, 2.0, 3.0});
	const measure::SheetMeasure bare =
	    measure::measure(set, polygonsOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), {});
	EXPECT_DOUBLE_EQ(bare.area, 0.5);
	EXPECT_EQ(bare.nan_area, 0.0);
	EXPECT_FALSE(bare.mean || bare.min || bare.max);
	const measure::SheetMeasure empty = measure::measure(set, polygonsOf({}, {}), kOnPoints);
	EXPECT_EQ(empty.area, 0.0);
	EXPECT_EQ(empty.components, 0u);
	EXPECT_FALSE(empty.mean || empty.min || empty.max);
}

TEST(Measure, CellDataAreConstantOnAPolygon)
{
	grid::BlockSet set = carrier({0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
	std::vector<double> cells(11, 100.0);
	cells[0] = 2.0;
	cells[1] = kNoValue;
	set.blocks[0].fields.push_back(grid::makeField("c", grid::Association::cell, 1, cells));
	const mesh::SheetMesh mesh =
	    polygonsOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {7, 0, 0}, {5, 2, 0}}, {{0, 1, 2}, {3, 4, 5}});
	const measure::SheetMeasure measure = measure::measure(set, mesh, kOnCells);
	EXPECT_DOUBLE_EQ(measure.nan_area, 2.0);
	EXPECT_EQ(measure::nanArea(set, mesh, kOnCells), measure.nan_area);
	EXPECT_DOUBLE_EQ(measure.mean.value(), 2.0);
	EXPECT_EQ(measure.min, 2.0);
	EXPECT_EQ(measure.max, 2.0);
}

TEST(Measure, ABlockWithoutTheArrayIsNan)
{
	grid::BlockSet set;
	set.blocks = {gridNamed("blob"), gridNamed("blob")};
	set.blocks[1].fields.clear();
	cut::Cutter cutter(set);
	const SlicedSheet sheet = cut(cutter, {{0.1, 0.2, 0.3}, {0.3, 0.5, 0.81}});
	const measure::SheetMeasure measure =
	    measure::measure(set, sheet.mesh, grid::FieldChoice{"linear", grid::Association::point, 0});
	EXPECT_NEAR(measure.nan_area, 0.5 * measure.area, 1e-12 * measure.area);
	EXPECT_TRUE(measure.mean);
}

TEST(Measure, AVectorShowsTheLengthOfItsInterpolatedValue)
{
	grid::Block block;
	block.grid = grid::UniformGrid({2, 2, 2}, Vec3(0.0), Vec3(1.0));
	std::vector<float> v(24, 0.0f);
	v[0] = 3.0f;
	v[4] = 4.0f;
	const grid::Field field = grid::makeField("v", grid::Association::point, 3, v);
	EXPECT_DOUBLE_EQ(mesh::interpolate(block, field, grid::kMagnitude, {0, 0, 1, 0.5}), 2.5);
	EXPECT_DOUBLE_EQ(mesh::interpolate(block, field, 0, {0, 0, 1, 0.25}), 2.25);
	EXPECT_DOUBLE_EQ(mesh::interpolate(block, field, 1, {0, 0, 1, 1.0}), 4.0);
}

TEST(Measure, AnEndWithoutPartDoesNotBringItsNan)
{
	grid::Block block;
	block.grid = grid::UniformGrid({2, 2, 2}, Vec3(0.0), Vec3(1.0));
	std::vector<double> s(8, kNoValue);
	s[0] = 5.0;
	const grid::Field field = grid::makeField("s", grid::Association::point, 1, s);
	EXPECT_EQ(mesh::interpolate(block, field, 0, {0, 0, 1, 0.0}), 5.0);
	EXPECT_TRUE(std::isnan(mesh::interpolate(block, field, 0, {0, 0, 1, 1e-9})));
	EXPECT_TRUE(std::isnan(mesh::interpolate(block, field, 0, {0, 0, 1, 1.0})));
}

TEST(Measure, CategoriesAreNotInterpolated)
{
	grid::Block block;
	block.grid = grid::UniformGrid({2, 2, 2}, Vec3(0.0), Vec3(1.0));
	block.fields.push_back(
	    grid::makeField<std::int32_t>("material", grid::Association::point, 1, {7, 3, 7, 3, 7, 3, 7, 3}));
	grid::finishBlock(block);
	const grid::Field& material = block.fields[0];
	EXPECT_EQ(mesh::interpolate(block, material, 0, {0, 0, 1, 0.0}), 7.0);
	EXPECT_EQ(mesh::interpolate(block, material, 0, {0, 0, 1, 0.49}), 7.0);
	EXPECT_EQ(mesh::interpolate(block, material, 0, {0, 0, 1, 0.51}), 3.0);
	EXPECT_EQ(mesh::interpolate(block, material, 0, {0, 0, 1, 0.5}), 3.0); // the lesser, from either side
	EXPECT_EQ(mesh::interpolate(block, material, 0, {0, 1, 2, 0.5}), 3.0);

	// In the middle of a window's rim too.
	const grid::BlockSet set = setOf(block);
	cut::Cutter cutter(set);
	cut::CutRequest request;
	request.in_generations = true;
	request.probe.sheets = {probe::makeSheet({0.4, 0.4, 0.4}, {0.3, 0.5, 0.81})};
	request.probe.sheets[0].window = probe::Window{-0.25, 0.2, -0.15, 0.2};
	const mesh::SheetMesh mesh = cutter.cut(request).value().mesh(set, 0);
	ASSERT_GT(mesh.positions.size(), mesh.edges.size());
	const grid::FieldChoice choice{"material", grid::Association::point, 0};
	for (std::size_t v = 0; v < mesh.positions.size(); ++v)
	{
		const double value = mesh::vertexValue(set, mesh, v, choice.inEach(set), 0);
		EXPECT_TRUE(value == 3.0 || value == 7.0) << value;
	}
}

// Over a flat sheet the mean of a linear field is its value at the centroid.
TEST(Measure, TheMeanOfALinearFieldIsItsValueAtTheCentroid)
{
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (const TestPlane& plane : randomPlanes(block.bounds, 20, 50))
		{
			const SlicedSheet sheet = cut(cutter, plane);
			double area = 0.0;
			Vec3 moment(0.0);
			for (std::size_t p = 0; p < sheet.mesh.polygons(); ++p)
			{
				const auto polygon = sheet.mesh.polygon(p);
				Vec3 middle(0.0);
				for (const std::uint32_t v : polygon)
					middle += sheet.mesh.positions[v] / static_cast<double>(polygon.size());
				for (std::size_t i = 0; i < polygon.size(); ++i)
				{
					const Vec3& a = sheet.mesh.positions[polygon[i]];
					const Vec3& b = sheet.mesh.positions[polygon[(i + 1) % polygon.size()]];
					const double part = 0.5 * glm::length(glm::cross(a - middle, b - middle));
					area += part;
					moment += part * (a + b + middle) / 3.0;
				}
			}
			if (area == 0.0)
				continue;
			const measure::SheetMeasure measure =
			    measure::measure(set, sheet.mesh, grid::FieldChoice{"linear", grid::Association::point, 0});
			EXPECT_NEAR(measure.area, area, 1e-12 * area);
			EXPECT_NEAR(measure.mean.value(), linearAt(moment / area), 1e-12 * block.bounds.diagonal());
			EXPECT_LE(measure.min.value(), measure.mean.value());
			EXPECT_GE(measure.max.value(), measure.mean.value());
		}
	}
}

} // namespace vp::test
