#include "mesh/nearest_parts.h"

#include "grid/field_choice.h"
#include "measure/value_areas.h"
#include "mesh/mesh_records.h"
#include "sliced_sheet.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vp::mesh::test
{

namespace
{

using vp::test::cut;
using vp::test::setOf;
using vp::test::SlicedSheet;
using vp::test::TestPlane;

// A lattice of n^3 points at distance 1 whose array "label" has these values; x runs fastest.
grid::BlockSet latticeOf(unsigned n, std::vector<std::int32_t> labels)
{
	grid::Block block;
	block.grid = grid::UniformGrid({n, n, n}, Vec3(0.0), Vec3(1.0));
	block.fields.push_back(grid::makeField("label", grid::Association::point, 1, std::move(labels)));
	grid::finishBlock(block);
	return setOf(block);
}

NearestParts partsOf(const SlicedSheet& sheet, const std::string& array)
{
	const grid::FieldChoice field{array};
	return nearestParts(*sheet.blocks, sheet.mesh, field.inEach(*sheet.blocks), 0);
}

std::map<double, double> areasOf(const grid::BlockSet& blocks, const TestPlane& plane)
{
	cut::Cutter cutter(blocks);
	const NearestParts parts = partsOf(cut(cutter, plane), "label");
	std::map<double, double> areas;
	for (const auto& [value, area] : measure::valueAreas(parts.mesh, parts.values))
		areas[value] = area.value();
	return areas;
}

double areaOf(const SheetMesh& mesh)
{
	double area = 0.0;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		area += 0.5 * glm::length(doubleArea(mesh, mesh.polygon(p)));
	return area;
}

} // namespace

TEST(NearestParts, APointHasItsVoxelsWholeSquare)
{
	// 7 in the middle of 27 points: its voxel is the cube from 0.5 to 1.5.
	std::vector<std::int32_t> labels(27, 2);
	labels[13] = 7;
	const grid::BlockSet blocks = latticeOf(3, labels);
	const auto near = areasOf(blocks, {Vec3(1.0, 1.0, 0.8), Vec3(0.0, 0.0, 1.0)});
	EXPECT_NEAR(near.at(7.0), 1.0, 1e-12);
	EXPECT_NEAR(near.at(2.0), 3.0, 1e-12);
	EXPECT_EQ(areasOf(blocks, {Vec3(1.0, 1.0, 0.3), Vec3(0.0, 0.0, 1.0)}).count(7.0), 0u);
	// Midway between two layers the lesser value has it.
	EXPECT_EQ(areasOf(blocks, {Vec3(1.0, 1.0, 0.5), Vec3(0.0, 0.0, 1.0)}).count(7.0), 0u);
	// x + y = 2 cuts the voxel in a rectangle of sqrt(2) by 1, and the lattice in one of 2 sqrt(2) by 2.
	const auto diagonal = areasOf(blocks, {Vec3(1.0), Vec3(1.0, 1.0, 0.0)});
	EXPECT_NEAR(diagonal.at(7.0), std::sqrt(2.0), 1e-12);
	EXPECT_NEAR(diagonal.at(2.0), 3.0 * std::sqrt(2.0), 1e-12);
	// x + y + z = 3 cuts a cube of side 1 through its center in a hexagon of area 3 sqrt(3) / 4.
	EXPECT_NEAR(areasOf(blocks, {Vec3(1.0), Vec3(1.0)}).at(7.0), 0.75 * std::sqrt(3.0), 1e-12);
}

// Four squares with nine corners: the middles of their twelve sides are corners of parts on both sides of each.
TEST(NearestParts, ASideIsPartedOnceForBothItsPolygons)
{
	std::vector<std::int32_t> labels(27);
	for (std::size_t p = 0; p < labels.size(); ++p)
		labels[p] = static_cast<std::int32_t>(p);
	const grid::BlockSet blocks = latticeOf(3, labels);
	cut::Cutter cutter(blocks);
	const NearestParts parts = partsOf(cut(cutter, {Vec3(1.0, 1.0, 0.8), Vec3(0.0, 0.0, 1.0)}), "label");
	EXPECT_EQ(parts.mesh.polygons(), 16u);
	int middles = 0;
	for (const Vec3& p : parts.mesh.positions)
		middles += (p.x == std::round(p.x)) != (p.y == std::round(p.y));
	EXPECT_EQ(middles, 12);
}

TEST(NearestParts, PartsCoverTheirPolygonAndHaveTheNearestPoint)
{
	std::mt19937 random(7);
	for (const grid::Block& given : vp::test::allGrids())
	{
		grid::Block block = given;
		const std::size_t points = block.fields.front().association == grid::Association::point
		                               ? block.fields.front().tuples()
		                               : std::get<grid::UnstructuredGrid>(block.grid).sourcePointCount();
		std::vector<std::int32_t> labels(points);
		for (std::int32_t& label : labels)
			label = static_cast<std::int32_t>(random() % 3);
		block.fields = {grid::makeField("label", grid::Association::point, 1, std::move(labels))};
		const grid::BlockSet blocks = setOf(block);
		cut::Cutter cutter(blocks);
		const Vec3 center = 0.5 * (block.bounds.lo + block.bounds.hi);
		const SlicedSheet sheet = cut(cutter, {center, Vec3(0.31, -0.52, 0.77)});
		const NearestParts parts = partsOf(sheet, "label");
		EXPECT_NEAR(areaOf(parts.mesh), areaOf(sheet.mesh), 1e-9 * areaOf(sheet.mesh)) << given.name;
		ASSERT_EQ(parts.values.size(), parts.mesh.polygons());
		EXPECT_EQ(parts.mesh.boundary_polygons, sheet.mesh.boundary_polygons);
		const double size = glm::length(block.bounds.hi - block.bounds.lo);
		std::visit(
		    [&](const auto& grid)
		    {
			    for (std::size_t p = 0; p < parts.mesh.polygons(); ++p)
			    {
				    const auto polygon = parts.mesh.polygon(p);
				    if (polygon.size() != 3) // the mean of others may lie outside of them
					    continue;
				    Vec3 middle(0.0);
				    for (const std::uint32_t v : polygon)
					    middle += parts.mesh.positions[v] / 3.0;
				    grid::CellFaces faces;
				    grid.cellFaces(parts.mesh.polygon_cells[p].cell, faces);
				    double nearest = size;
				    for (const PointId point : faces.points)
					    nearest = std::min(nearest, glm::length(grid.point(point) - middle));
				    bool has_value = false;
				    for (const PointId point : faces.points)
					    has_value = has_value || (glm::length(grid.point(point) - middle) <= nearest + 1e-9 * size &&
					                              block.fields[0].value(grid.sourcePoint(point), 0) == parts.values[p]);
				    EXPECT_TRUE(has_value) << given.name << " polygon " << p;
			    }
		    },
		    block.grid);
	}
}

TEST(NearestParts, SidesBetweenPartsAreNoLinesOfTheMesh)
{
	// One cell, in x = 0 another label than in x = 1.
	const grid::BlockSet blocks = latticeOf(2, {1, 4, 1, 4, 1, 4, 1, 4});
	cut::Cutter cutter(blocks);
	const SlicedSheet sheet = cut(cutter, {Vec3(0.5), Vec3(0.0, 0.0, 1.0)});
	const NearestParts parts = partsOf(sheet, "label");
	ASSERT_EQ(parts.mesh.polygons(), 2u);
	// Each part has the line in the middle, in two pieces. They share its ends and the center.
	EXPECT_EQ(std::ranges::count(parts.mesh.is_inner, 1), 4);
	EXPECT_EQ(parts.mesh.positions.size(), 4u + 3u);
	const MeshRecords records(sheet.slice.sheet, parts.mesh, parts.values);
	std::vector<shared::PolygonRecord> written(records.count());
	records.write(0, written);
	ASSERT_EQ(written.size(), 2u);
	for (const shared::PolygonRecord& record : written)
	{
		int hidden = 0;
		for (int side = 0; side < 5; ++side)
			hidden += (record.vertices & shared::kHiddenRecordEdge << side) != 0;
		EXPECT_EQ(hidden, 2);
	}
}

} // namespace vp::mesh::test
