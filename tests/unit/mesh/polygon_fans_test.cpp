#include "mesh/polygon_fans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::test
{

namespace
{

using glm::dvec2;
using Polygon = std::vector<dvec2>;

double twiceArea(const dvec2& a, const dvec2& b, const dvec2& c)
{
	return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double area(const Polygon& polygon)
{
	double twice = 0.0;
	for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
		twice += twiceArea(polygon[0], polygon[i], polygon[i + 1]);
	return 0.5 * twice;
}

// Triangles, none clockwise, of the polygon's area: they cover it once.
void expectCover(const Polygon& polygon)
{
	double sum = 0.0;
	std::size_t triangles = 0;
	for (const std::vector<std::uint32_t>& fan : mesh::cutIntoFans(polygon))
		for (std::size_t i = 1; i + 1 < fan.size(); ++i, ++triangles)
		{
			const double twice = twiceArea(polygon[fan[0]], polygon[fan[i]], polygon[fan[i + 1]]);
			EXPECT_GE(twice, -1e-9);
			sum += 0.5 * twice;
		}
	EXPECT_LE(triangles, polygon.size() - 2);
	EXPECT_NEAR(sum, area(polygon), 1e-12);
}

Polygon turned(Polygon polygon, std::size_t by)
{
	std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(by), polygon.end());
	return polygon;
}

const Polygon kDart{{0, 0}, {2, -1}, {0.5, 0}, {2, 1}}; // reflex at (0.5, 0)

Polygon comb(int teeth)
{
	Polygon polygon{{0, 0}, {static_cast<double>(teeth), 0}};
	for (int t = teeth; t-- > 0;)
	{
		polygon.emplace_back(t + 0.9, 3.0);
		polygon.emplace_back(t + 0.1, 1.0);
	}
	return polygon;
}

} // namespace

TEST(PolygonFans, ConvexOnesAreFansWhereverTheyBegin)
{
	const Polygon with_straight_corner{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}};
	for (std::size_t start = 0; start < 5; ++start)
		EXPECT_TRUE(mesh::isFan(turned(with_straight_corner, start)));
}

TEST(PolygonFans, ADartBeginsAtItsReflexCorner)
{
	EXPECT_TRUE(mesh::isFan(kDart));
	EXPECT_FALSE(mesh::isFan(turned(kDart, 1)));
	for (std::size_t start = 0; start < 4; ++start)
	{
		expectCover(turned(kDart, start));
		EXPECT_EQ(mesh::cutIntoFans(turned(kDart, start)).size(), 1u);
	}
}

TEST(PolygonFans, NoCornerOfACombSeesAllOthers)
{
	const Polygon polygon = comb(5);
	EXPECT_GT(mesh::cutIntoFans(polygon).size(), 1u);
	for (std::size_t start = 0; start < polygon.size(); ++start)
		expectCover(turned(polygon, start));
}

TEST(PolygonFans, ASpiral)
{
	Polygon polygon;
	constexpr int kSteps = 40;
	for (int i = 0; i <= kSteps; ++i)
		polygon.push_back((1.0 + 0.1 * i) * dvec2(std::cos(0.3 * i), std::sin(0.3 * i)));
	for (int i = kSteps; i >= 0; --i)
		polygon.push_back((0.5 + 0.1 * i) * dvec2(std::cos(0.3 * i), std::sin(0.3 * i)));
	ASSERT_GT(area(polygon), 0.0);
	expectCover(polygon);
}

// Two squares whose bridge is walked both ways, as clipping a concave polygon leaves.
TEST(PolygonFans, ABridgeWithoutWidth)
{
	expectCover({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0}, {1, 0}, {1, 1}, {0, 1}});
}

TEST(PolygonFans, WhatCrossesItselfOrIsTooLargeComesBackWhole)
{
	const auto count = [](const Polygon& polygon)
	{
		std::size_t triangles = 0;
		for (const auto& fan : mesh::cutIntoFans(polygon))
			triangles += fan.size() - 2;
		return triangles;
	};
	const Polygon bow{{0, 0}, {2, 2}, {2, 0}, {0, 1}, {1, 3}};
	EXPECT_EQ(count(bow), 3u);
	Polygon star;
	for (std::size_t i = 0; i < 2 * mesh::kMaxEarCorners; ++i)
	{
		const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(mesh::kMaxEarCorners);
		star.push_back((i % 2 ? 1.0 : 2.0) * dvec2(std::cos(angle), std::sin(angle)));
	}
	EXPECT_EQ(count(star), star.size() - 2);
}

} // namespace vp::test
