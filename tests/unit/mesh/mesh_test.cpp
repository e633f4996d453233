#include "mesh/mesh_seams.h"
#include "mesh/mesh_values.h"
#include "sliced_sheet.h"
#include "test_grids.h"
#include "tries.h"
#include "watertight_mesh.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace vp::test
{

namespace
{

std::vector<TestPlane> planesFor(const grid::Block& block)
{
	std::vector<TestPlane> planes = randomPlanes(block.bounds, tries(60), 30);
	const std::vector<TestPlane> more = degeneratePlanes(block, 31);
	planes.insert(planes.end(), more.begin(), more.end());
	return planes;
}

// Calls visit(block, plane, sheet) for every test grid and plane.
template <class Visit>
void forEachCut(std::vector<TestPlane> (*planes)(const grid::Block&), Visit&& visit)
{
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (const TestPlane& plane : planes(block))
		{
			visit(block, plane, cut(cutter, plane));
			if (testing::Test::HasFailure())
			{
				ADD_FAILURE() << block.name << ", origin " << plane.origin.x << ' ' << plane.origin.y << ' '
				              << plane.origin.z << ", normal " << plane.normal.x << ' ' << plane.normal.y << ' '
				              << plane.normal.z;
				return;
			}
		}
	}
}

Vec3 vectorArea(const mesh::SheetMesh& mesh, std::size_t polygon)
{
	Vec3 sum(0.0);
	const auto corners = mesh.polygon(polygon);
	for (std::size_t i = 1; i + 1 < corners.size(); ++i)
		sum += glm::cross(mesh.positions[corners[i]] - mesh.positions[corners[0]],
		                  mesh.positions[corners[i + 1]] - mesh.positions[corners[0]]);
	return 0.5 * sum;
}

} // namespace

TEST(Mesh, EveryVertexLiesOnAnEdgeOfItsCell)
{
	forEachCut(planesFor,
	           [](const grid::Block& block, const TestPlane& plane, const SlicedSheet& sheet)
	           {
		           const mesh::SheetMesh& mesh = sheet.mesh;
		           const Side side(plane);
		           const double scale = block.bounds.diagonal();
		           for (std::size_t p = 0; p < mesh.polygons(); ++p)
		           {
			           const CellEdges cell = edgesOf(block, mesh.polygon_cells[p].cell);
			           for (const std::uint32_t v : mesh.polygon(p))
			           {
				           const mesh::EdgePoint& edge = mesh.edges[v];
				           const auto [a, b] =
				               visitGrid(block, [&](const auto& grid)
				                         { return std::pair(grid.point(edge.lower), grid.point(edge.higher)); });
				           EXPECT_TRUE(edge.t >= 0.0 && edge.t <= 1.0);
				           EXPECT_LT(glm::length(mesh.positions[v] - (a + edge.t * (b - a))), 1e-14 * scale);
				           EXPECT_LT(std::abs(side.distance(mesh.positions[v])), 1e-14 * scale);
				           // A vertex at a grid point may go by the name of another edge there.
				           if (edge.t != 0.0 && edge.t != 1.0)
				           {
					           EXPECT_TRUE(cell.edges.contains({edge.lower, edge.higher}));
				           }
			           }
		           }
	           });
}

TEST(Mesh, ACutEdgeIsOneVertex)
{
	forEachCut(planesFor,
	           [](const grid::Block&, const TestPlane&, const SlicedSheet& sheet)
	           {
		           std::set<std::pair<PointId, PointId>> edges;
		           std::set<PointId> points;
		           for (const mesh::EdgePoint& edge : sheet.mesh.edges)
		           {
			           EXPECT_TRUE(edges.insert({edge.lower, edge.higher}).second);
			           if (edge.t == 0.0 || edge.t == 1.0)
			           {
				           EXPECT_TRUE(points.insert(edge.t == 0.0 ? edge.lower : edge.higher).second);
			           }
		           }
		           std::set<std::uint32_t> used(sheet.mesh.polygon_vertices.begin(), sheet.mesh.polygon_vertices.end());
		           EXPECT_EQ(used.size(), sheet.mesh.positions.size()) << "vertices of no polygon";
	           });
}

TEST(Mesh, PolygonsFaceAlongTheNormalAndHaveArea)
{
	forEachCut(planesFor,
	           [](const grid::Block&, const TestPlane&, const SlicedSheet& sheet)
	           {
		           const mesh::SheetMesh& mesh = sheet.mesh;
		           for (std::size_t p = 0; p < mesh.polygons(); ++p)
		           {
			           const auto polygon = mesh.polygon(p);
			           ASSERT_GE(polygon.size(), 3u);
			           for (std::size_t i = 0; i < polygon.size(); ++i)
				           EXPECT_NE(polygon[i], polygon[(i + 1) % polygon.size()]);
			           EXPECT_GT(glm::dot(vectorArea(mesh, p), sheet.slice.sheet.normal), 0.0);
		           }
	           });
}

TEST(Mesh, IsWatertight)
{
	const auto planes = [](const grid::Block& block)
	{ return conforms(block) ? randomPlanes(block.bounds, 60, 32) : std::vector<TestPlane>(); };
	forEachCut(planes, [](const grid::Block& block, const TestPlane&, const SlicedSheet& sheet)
	           { expectWatertight(block, sheet.mesh); });
}

TEST(Mesh, ALinearFieldIsExact)
{
	forEachCut(planesFor,
	           [](const grid::Block& block, const TestPlane&, const SlicedSheet& sheet)
	           {
		           const auto linear = std::ranges::find(block.fields, "linear", &grid::Field::name);
		           for (std::size_t v = 0; v < sheet.mesh.positions.size(); ++v)
			           EXPECT_NEAR(mesh::interpolate(block, *linear, 0, sheet.mesh.edges[v]),
			                       linearAt(sheet.mesh.positions[v]), 1e-13 * block.bounds.diagonal());
	           });
}

TEST(Mesh, TwistedCellsAreCountedAndCutWhole)
{
	for (const char* name : {"warped_hexahedra", "warped_curvilinear"})
	{
		const grid::BlockSet set = setOf(gridNamed(name));
		cut::Cutter cutter(set);
		std::size_t twisted = 0;
		std::size_t several = 0;
		for (const TestPlane& plane : randomPlanes(set.bounds(), 200, 33))
		{
			const SlicedSheet sheet = cut(cutter, plane);
			std::map<CellId, int> polygons;
			for (const mesh::BlockCell& from : sheet.mesh.polygon_cells)
				++polygons[from.cell];
			EXPECT_EQ(polygons.size(), sheet.cutCellCount()) << "a cell was dropped";
			const auto more =
			    static_cast<std::size_t>(std::ranges::count_if(polygons, [](const auto& p) { return p.second > 1; }));
			EXPECT_LE(more, sheet.mesh.cells_twisted);
			several += more;
			twisted += sheet.mesh.cells_twisted;
		}
		EXPECT_GT(twisted, 0u);
		EXPECT_GT(several, 0u);
	}
}

// Where blocks know no neighbors, the polygons tell which faces meet: here one of each block.
TEST(Mesh, SeamsAreFoundFromTheFirstPolygonOn)
{
	grid::BlockSet blocks;
	mesh::SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	for (std::uint32_t b = 0; b < 2; ++b)
	{
		grid::Block block;
		block.grid = grid::UniformGrid({2, 2, 2}, Vec3(b, 0.0, 0.0), Vec3(1.0));
		grid::finishBlock(block);
		blocks.blocks.push_back(block);
		for (const PointId low : {0u, 1u, 3u, 2u})
		{
			mesh.polygon_vertices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
			mesh.edges.push_back({b, low, low + 4, 0.5});
			mesh.positions.push_back(Vec3(b + low % 2, low / 2, 0.5));
		}
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
		mesh.polygon_cells.push_back({b, 0});
	}
	UnionFind joined(mesh.positions.size());
	EXPECT_EQ(mesh::seamsOfMesh(blocks, mesh, joined).seam_faces, 2u);
}

TEST(Mesh, AMeshWithoutABlockKeepsWhatTheOthersHave)
{
	mesh::SheetMesh mesh;
	mesh.polygon_starts = {0};
	for (std::uint32_t p = 0; p < 3; ++p)
	{
		for (std::uint32_t corner = 0; corner < 3; ++corner)
		{
			mesh.polygon_vertices.push_back(3 * p + corner);
			mesh.is_added.push_back(corner == p);
		}
		mesh.polygon_starts.push_back(3 * p + 3);
		mesh.polygon_cells.push_back({p, p});
	}
	mesh.boundary_polygons = 1;
	const mesh::SheetMesh rest = mesh::withoutBlocks(mesh, {false, true, false});
	ASSERT_EQ(rest.polygons(), 2u);
	EXPECT_EQ(rest.is_added, (std::vector<std::uint8_t>{1, 0, 0, 0, 0, 1}));
	EXPECT_EQ(rest.polygon(1)[2], 8u);
	EXPECT_EQ(rest.boundary_polygons, 1u);
}

// A mesh is made in parts of some thousand cells, which share vertices all the same.
TEST(Mesh, ALongMeshHasEachVertexOnce)
{
	const grid::Block block = explicitHexahedra(80, [](int i, int j, int k) { return k > 1 || (i + 2 * j) % 9 != 0; });
	const grid::BlockSet blocks = setOf(block);
	for (const find::Strategy strategy : {find::Strategy::cells, find::Strategy::scan, find::Strategy::generations})
	{
		cut::Cutter cutter(blocks);
		cut::CutRequest request;
		request.strategy = strategy;
		request.probe.sheets = {probe::makeSheet(Vec3(0.5, 0.5, 0.013), Vec3(0.002, 0.005, 1.0))};
		const cut::Cut slice = std::move(cutter.cut(std::move(request)).value());
		ASSERT_GT(slice.sheets[0].cuts[0].cutCells(), 2u * 2048u);
		const mesh::SheetMesh sheet = slice.mesh(blocks, 0);
		std::set<std::pair<PointId, PointId>> vertices;
		for (const mesh::EdgePoint& edge : sheet.edges)
			vertices.emplace(edge.lower, edge.higher);
		EXPECT_EQ(vertices.size(), sheet.edges.size()) << static_cast<int>(strategy);
	}
}

} // namespace vp::test
