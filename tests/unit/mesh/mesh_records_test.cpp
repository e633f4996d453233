#include "mesh/mesh_records.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

namespace vp::test
{

namespace
{

const probe::Sheet kSheet = probe::makeSheet({1.0, 2.0, 3.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0});

// Polygons side by side in the plane z = 3, with 3 to 12 corners; every seventh is a star, of which no corner sees all.
mesh::SheetMesh manyPolygons(std::size_t count)
{
	mesh::SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	for (std::size_t p = 0; p < count; ++p)
	{
		const bool star = p % 7 == 3;
		const std::size_t corners = star ? 10 : 3 + p % 10;
		for (std::size_t i = 0; i < corners; ++i)
		{
			const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
			const double radius = star && i % 2 == 0 ? 0.1 : 0.4;
			mesh.polygon_vertices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
			mesh.positions.push_back({static_cast<double>(p % 100) + radius * std::cos(angle),
			                          static_cast<double>(p / 100) + radius * std::sin(angle), 3.0});
		}
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
		mesh.polygon_cells.push_back({0, static_cast<CellId>(p)});
	}
	return mesh;
}

std::uint32_t cornersOf(const shared::PolygonRecord& record)
{
	return record.vertices & shared::kRecordVertices;
}

double area(const shared::PolygonRecord& record)
{
	double twice = 0.0;
	for (std::uint32_t i = 1; i + 1 < cornersOf(record); ++i)
	{
		const auto at = [&](std::uint32_t v)
		{ return glm::dvec2(record.uv[2 * v] - record.uv[0], record.uv[2 * v + 1] - record.uv[1]); };
		twice += at(i).x * at(i + 1).y - at(i).y * at(i + 1).x;
	}
	return 0.5 * twice;
}

} // namespace

TEST(MeshRecords, HoldEveryPolygonInOrder)
{
	constexpr std::size_t kPolygons = 5000;
	const mesh::SheetMesh mesh = manyPolygons(kPolygons);
	std::vector<double> polygon_values;
	for (std::size_t p = 0; p < kPolygons; ++p)
		polygon_values.push_back(p == 17 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(p));
	const mesh::MeshRecords records(kSheet, mesh, polygon_values);
	std::vector<shared::PolygonRecord> all(records.count());
	records.write(0, all);

	std::size_t next = 0;
	for (std::size_t p = 0; p < kPolygons; ++p)
	{
		double sum = 0.0;
		for (; next < all.size() && all[next].cell == p; ++next)
		{
			sum += area(all[next]);
			EXPECT_EQ(all[next].value[2], p == 17 ? shared::kNanValue : static_cast<float>(p));
			EXPECT_GE(cornersOf(all[next]), 3u);
			EXPECT_LE(cornersOf(all[next]), shared::kMaxRecordVertices);
		}
		const double expected = 0.5 * glm::length(mesh::doubleArea(mesh, mesh.polygon(p)));
		EXPECT_NEAR(sum, expected, 1e-4) << p;
	}
	EXPECT_EQ(next, all.size());
}

TEST(MeshRecords, ComeInPartsAsInWhole)
{
	const mesh::SheetMesh mesh = manyPolygons(3300);
	const mesh::MeshRecords records(grid::BlockSet(), kSheet, mesh, std::nullopt);
	std::vector<shared::PolygonRecord> all(records.count());
	records.write(0, all);
	for (const std::size_t part : {1000u, 1024u, 4097u})
	{
		std::vector<shared::PolygonRecord> parts(records.count());
		for (std::size_t first = 0; first < parts.size(); first += part)
			records.write(first, std::span(parts).subspan(first, std::min(part, parts.size() - first)));
		EXPECT_EQ(std::memcmp(parts.data(), all.data(), sizeof(all[0]) * all.size()), 0) << part;
	}
	records.write(3, {});
}

TEST(MeshRecords, ArePartedWhereBlocksBegin)
{
	mesh::SheetMesh mesh = manyPolygons(3300);
	EXPECT_TRUE(mesh::MeshRecords(kSheet, mesh, std::vector<double>(3300)).parts().empty());
	const std::vector<CellId> begins{5, 1024, 1025, 3000};
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		mesh.polygon_cells[p].block =
		    static_cast<std::uint32_t>(std::ranges::upper_bound(begins, mesh.polygon_cells[p].cell) - begins.begin());
	const mesh::MeshRecords records(kSheet, mesh, std::vector<double>(3300));
	std::vector<shared::PolygonRecord> all(records.count());
	records.write(0, all);
	ASSERT_EQ(records.parts().size(), begins.size());
	for (std::size_t i = 0; i < begins.size(); ++i)
	{
		EXPECT_EQ(all[records.parts()[i]].cell, begins[i]);
		EXPECT_NE(all[records.parts()[i] - 1].cell, begins[i]);
	}
}

TEST(MeshRecords, KnowWhereTheyAre)
{
	const mesh::SheetMesh mesh = manyPolygons(250);
	const mesh::UvBounds bounds = mesh::MeshRecords(kSheet, mesh, std::vector<double>(250)).bounds();
	glm::dvec2 lo(1e9);
	glm::dvec2 hi(-1e9);
	for (const Vec3& p : mesh.positions)
	{
		lo = glm::min(lo, glm::dvec2(p.x - 1.0, p.y - 2.0));
		hi = glm::max(hi, glm::dvec2(p.x - 1.0, p.y - 2.0));
	}
	EXPECT_NEAR(glm::length(bounds.lo - lo), 0.0, 1e-12);
	EXPECT_NEAR(glm::length(bounds.hi - hi), 0.0, 1e-12);

	// The bounds of a polygon of 8 corners, between (-0.4, -0.4) and (0.4, 0.4); no other one has larger ones, the last
	// one neither.
	const mesh::SheetMesh few = manyPolygons(7);
	EXPECT_NEAR(mesh::MeshRecords(kSheet, few, std::vector<double>(7)).longest(), 0.8 * std::sqrt(2.0), 1e-12);

	const mesh::SheetMesh none = manyPolygons(0);
	EXPECT_EQ(mesh::MeshRecords(kSheet, none, {}).count(), 0u);
}

} // namespace vp::test
