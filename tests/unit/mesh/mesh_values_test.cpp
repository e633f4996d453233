#include "mesh/mesh_values.h"

#include "mesh/mesh_records.h"
#include "mesh/mesh_seams.h"
#include "sliced_sheet.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <set>
#include <utility>

namespace vp::test
{

// A vertex at an end of its edge has the value there, whatever the other end has, in short lists and in long ones.
TEST(MeshValues, AVertexAtAPointHasItsValue)
{
	constexpr double kInfinity = std::numeric_limits<double>::infinity();
	constexpr unsigned kEdges = 60;
	grid::Block block;
	block.grid = grid::UniformGrid({2, kEdges, 1}, Vec3(0.0), Vec3(1.0));
	std::vector<double> values;
	for (unsigned j = 0; j < kEdges; ++j)
	{
		values.push_back(j % 2 ? kInfinity : j);
		values.push_back(j % 2 ? j : kInfinity);
	}
	block.fields.push_back(grid::makeField("f", grid::Association::point, 1, values));
	grid::finishBlock(block);
	const grid::BlockSet blocks = setOf(block);
	for (const unsigned parity : {0u, 1u}) // all at their lower ends, all at their higher ones
	{
		mesh::SheetMesh mesh;
		for (unsigned j = parity; j < kEdges; j += 2)
			for (int twice = 0; twice < 2; ++twice)
			{
				mesh.edges.push_back({0, 2 * j, 2 * j + 1, static_cast<double>(parity)});
				mesh.positions.push_back(Vec3(parity, j, 0.0));
			}
		const auto at = mesh::vertexValues(blocks, mesh, grid::FieldChoice{"f"}.inEach(blocks), 0);
		ASSERT_EQ(at.size(), kEdges);
		for (std::size_t v = 0; v < at.size(); ++v)
			EXPECT_EQ(at[v], static_cast<double>(v / 2 * 2 + parity)) << v;
	}
}

// In single precision, at the places that they have in the sheet.
TEST(MeshValues, RecordsHaveThoseOfTheirVertices)
{
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet blocks = setOf(block);
		cut::Cutter cutter(blocks);
		const TestPlane plane{block.bounds.center(), Vec3(0.3, 0.5, 0.8)};
		const SlicedSheet sheet = cut(cutter, plane);
		const mesh::MeshRecords records(blocks, sheet.slice.sheet, sheet.mesh, grid::FieldChoice{"linear"});
		std::vector<shared::PolygonRecord> all(records.count());
		records.write(0, all);
		const double size = block.bounds.diagonal() + glm::length(block.bounds.center());
		for (const shared::PolygonRecord& record : all)
			for (std::uint32_t corner = 0; corner < (record.vertices & shared::kRecordVertices); ++corner)
			{
				const Vec3 at = sheet.slice.sheet.origin + double(record.uv[2 * corner]) * sheet.slice.sheet.xAxis() +
				                double(record.uv[2 * corner + 1]) * sheet.slice.sheet.up;
				EXPECT_NEAR(record.value[corner], linearAt(at), 1e-5 * (1.0 + size)) << block.name;
			}
	}
}

// Where blocks know no neighbors, the polygons tell which faces meet: here one of each block.
TEST(MeshValues, SeamsAreFoundFromTheFirstPolygonOn)
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

TEST(MeshValues, AMeshWithoutABlockKeepsWhatTheOthersHave)
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
TEST(MeshValues, ALongMeshHasEachVertexOnce)
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
