#include "mesh/mesh_values.h"

#include "mesh/mesh_records.h"
#include "sliced_sheet.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <limits>

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

} // namespace vp::test
