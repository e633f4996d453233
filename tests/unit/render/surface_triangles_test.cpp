#include "render/passes/surface_triangles.h"

#include "render/passes/corner_normals.h"
#include "shared/slice_types.h"

#include <glm/packing.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vp::render
{

namespace
{

mesh::SheetMesh meshOf(std::vector<Vec3> positions, const std::vector<std::vector<std::uint32_t>>& polygons)
{
	mesh::SheetMesh mesh;
	mesh.positions.assign(positions.begin(), positions.end());
	mesh.polygon_starts.push_back(0);
	for (const auto& polygon : polygons)
	{
		mesh.polygon_vertices.insert(mesh.polygon_vertices.end(), polygon.begin(), polygon.end());
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
		mesh.polygon_cells.push_back({});
	}
	return mesh;
}

// A strip of quadrangles bent about the y axis, `angle` degrees from one to the next.
mesh::SheetMesh bentStrip(int count, double angle)
{
	std::vector<Vec3> positions;
	std::vector<std::vector<std::uint32_t>> polygons;
	Vec3 at(0.0);
	for (int i = 0; i <= count; ++i)
	{
		positions.insert(positions.end(), {at, at + Vec3(0.0, 1.0, 0.0)});
		const double turn = i * angle * std::numbers::pi / 180.0;
		at += Vec3(std::cos(turn), 0.0, std::sin(turn));
	}
	for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i)
		polygons.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
	return meshOf(positions, polygons);
}

std::uint32_t vertexOf(const shared::SurfaceTriangle& triangle, int corner)
{
	return triangle.corners[corner] & ~shared::kHiddenEdge;
}

Vec3 place(const SurfacePart& part, const shared::SurfaceTriangle& triangle, int corner)
{
	return Vec3(part.vertices.at(vertexOf(triangle, corner)));
}

double areaOf(const std::vector<SurfacePart>& parts)
{
	double sum = 0.0;
	for (const SurfacePart& part : parts)
		for (const auto& t : part.triangles)
			sum += 0.5 * glm::length(
			                 glm::cross(place(part, t, 1) - place(part, t, 0), place(part, t, 2) - place(part, t, 0)));
	return sum;
}

// The length of what is an edge of a polygon.
double edgesOf(const std::vector<SurfacePart>& parts)
{
	double sum = 0.0;
	for (const SurfacePart& part : parts)
		for (const auto& t : part.triangles)
			for (int k = 0; k < 3; ++k)
				if (!(t.corners[k] & shared::kHiddenEdge))
					sum += glm::length(place(part, t, (k + 1) % 3) - place(part, t, k));
	return sum;
}

} // namespace

TEST(SurfaceTriangles, CoverAConcavePolygonAndNothingElse)
{
	// An L of three unit squares in a slanted plane, from each of its corners on, either way round.
	const Vec3 x = glm::normalize(Vec3(1.0, 2.0, -0.5));
	const Vec3 y = glm::normalize(glm::cross(Vec3(0.3, 0.1, 1.0), x));
	std::vector<Vec3> corners;
	for (const auto& [u, v] : {std::pair{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})
		corners.push_back(Vec3(5.0, 6.0, 7.0) + double(u) * x + double(v) * y);
	for (std::uint32_t first = 0; first < 6; ++first)
		for (const std::uint32_t step : {1u, 5u})
		{
			std::vector<std::uint32_t> polygon;
			for (std::uint32_t i = 0; i < 6; ++i)
				polygon.push_back((first + step * i) % 6);
			const auto parts = surfaceTriangles(meshOf(corners, {polygon}), {}, corners[0], 1000);
			ASSERT_EQ(parts.size(), 1u);
			EXPECT_EQ(parts[0].triangles.size(), 4u);
			EXPECT_EQ(parts[0].vertices.size(), 6u);
			EXPECT_NEAR(areaOf(parts), 3.0, 1e-5);
			EXPECT_NEAR(edgesOf(parts), 8.0, 1e-5);
		}
}

TEST(SurfaceTriangles, WidthIsThePolygons)
{
	const auto parts =
	    surfaceTriangles(meshOf({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3}}), {}, {}, 99);
	// A half square's 4 area / perimeter is 2 s / (2 + sqrt 2), the square's is s.
	for (const auto& triangle : parts.at(0).triangles)
		EXPECT_NEAR(triangle.width, (2.0 + std::numbers::sqrt2) / 2.0, 1e-5);
}

TEST(SurfaceTriangles, InPartsAreTheSame)
{
	const mesh::SheetMesh mesh = bentStrip(50, 3.0);
	std::vector<double> values;
	for (const Vec3& p : mesh.positions)
		values.push_back(p.x + 10.0 * p.y);
	const auto whole = surfaceTriangles(mesh, {values, {}}, {}, 100'000);
	ASSERT_EQ(whole.size(), 1u);
	for (const std::size_t most : {16u, 31u, 64u})
	{
		const auto parts = surfaceTriangles(mesh, {values, {}}, {}, most);
		EXPECT_GE(parts.size(), 100u * shared::kSurfaceTexels / most);
		std::size_t triangle = 0;
		for (const SurfacePart& part : parts)
		{
			EXPECT_LE(part.triangles.size() * shared::kSurfaceTexels, most);
			EXPECT_LE(part.vertices.size(), most);
			for (const auto& t : part.triangles)
			{
				const auto& same = whole[0].triangles.at(triangle++);
				for (int k = 0; k < 3; ++k)
					EXPECT_EQ(part.vertices.at(vertexOf(t, k)), whole[0].vertices.at(vertexOf(same, k)));
			}
		}
		EXPECT_EQ(triangle, whole[0].triangles.size());
	}
}

TEST(SurfaceTriangles, OnePolygonWithNanHasNoValueAnywhere)
{
	const double nan = std::numeric_limits<double>::quiet_NaN();
	const mesh::SheetMesh mesh = bentStrip(3, 0.0);
	std::vector<double> values(mesh.positions.size(), 1.0);
	values[0] = nan;
	const auto by_vertex = surfaceTriangles(mesh, {values, {}}, {}, 999);
	const auto by_polygon = surfaceTriangles(mesh, {{}, std::vector{2.0, nan, 4.0}}, {}, 999);
	for (std::size_t t = 0; t < 6; ++t)
	{
		EXPECT_EQ(by_vertex[0].triangles.at(t).value, t < 2 ? shared::kNanValue : 0.0f);
		EXPECT_EQ(by_polygon[0].triangles.at(t).value, t / 2 == 0 ? 2.0f : t / 2 == 1 ? shared::kNanValue : 4.0f);
	}
}

TEST(SurfaceTriangles, InfiniteThroughoutOrNoValue)
{
	const double infinity = std::numeric_limits<double>::infinity();
	const mesh::SheetMesh mesh = bentStrip(3, 0.0);
	const std::vector<double> values{infinity, infinity, infinity, infinity, 1.0, 1.0, 1.0, 1.0};
	const auto parts = surfaceTriangles(mesh, {values, {}}, {}, 999);
	for (std::size_t t = 0; t < 6; ++t)
		EXPECT_EQ(parts[0].triangles.at(t).value, t / 2 == 0   ? shared::kInfiniteValue
		                                          : t / 2 == 1 ? shared::kNanValue
		                                                       : 0.0f);
}

TEST(SurfaceTriangles, ValuesAcrossEdges)
{
	const double nan = std::numeric_limits<double>::quiet_NaN();
	const auto parts = surfaceTriangles(bentStrip(4, 5.0), {{}, std::vector{1.0, 2.0, nan, 4.0}}, {}, 999);
	std::vector<std::vector<float>> seen(4);
	for (std::size_t t = 0; t < 8; ++t)
		for (int k = 0; k < 3; ++k)
		{
			const auto& triangle = parts[0].triangles.at(t);
			const float own = t / 2 == 2 ? shared::kNanValue : static_cast<float>(t / 2 + 1);
			if (parts[0].across.at(t)[k] == own)
				continue;
			seen[t / 2].push_back(parts[0].across[t][k]);
			// Only edges along y lead to a neighbor.
			EXPECT_FALSE(triangle.corners[k] & shared::kHiddenEdge);
			EXPECT_NEAR(std::abs(place(parts[0], triangle, (k + 1) % 3).y - place(parts[0], triangle, k).y), 1.0, 1e-6);
		}
	using Values = std::vector<float>;
	EXPECT_EQ(seen[0], Values{2.0f});
	EXPECT_EQ(seen[1], Values{1.0f});
	std::ranges::sort(seen[2]);
	EXPECT_EQ(seen[2], (Values{2.0f, 4.0f}));
	EXPECT_TRUE(seen[3].empty()); // across is NaN
}

TEST(CornerNormals, AreSmoothUpToACrease)
{
	for (const double angle : {10.0, 50.0})
	{
		mesh::SheetMesh mesh = bentStrip(2, angle);
		// The second polygon the other way round: a surface has no side.
		std::reverse(mesh.polygon_vertices.begin() + 4, mesh.polygon_vertices.end());
		const std::vector<Vec3f> normals = cornerNormals(mesh);
		const auto turned = [](double degrees)
		{
			const double t = degrees * std::numbers::pi / 180.0;
			return Vec3f(std::sin(t), 0.0, -std::cos(t));
		};
		for (std::size_t i = 0; i < normals.size(); ++i)
		{
			const bool shared_edge = mesh.polygon_vertices[i] == 2 || mesh.polygon_vertices[i] == 3;
			const double own = i < 4 ? 0.0 : angle;
			const Vec3f expected = turned(shared_edge && angle < 30.0 ? 0.5 * angle : own);
			EXPECT_NEAR(std::abs(glm::dot(normals[i], expected)), 1.0, 1e-6) << i;
			EXPECT_EQ(glm::dot(normals[i], turned(own)) > 0.0f, glm::dot(normals[i < 4 ? 0 : 4], turned(own)) > 0.0f);
		}
	}
}

} // namespace vp::render
