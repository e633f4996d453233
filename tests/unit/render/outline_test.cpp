#include "grid/demo/demo.h"
#include "render/scene/outline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vp::render
{

namespace
{

grid::BlockSet demo(const char* text)
{
	auto made = grid::parseDemo(text);
	EXPECT_TRUE(made) << text;
	return std::move(*made);
}

double length(const std::vector<Segment>& segments)
{
	double sum = 0.0;
	for (const Segment& s : segments)
		sum += glm::length(s.b - s.a);
	return sum;
}

} // namespace

TEST(Outline, ABoxHasTwelveEdges)
{
	for (const char* name : {"blob:5", "graded:5", "mixed:6"})
	{
		const auto segments = outlineOf(demo(name), Outline::box);
		EXPECT_EQ(segments.size(), 12u) << name;
		EXPECT_NEAR(length(segments), 12 * 6.0, 1e-9) << name;
	}
	EXPECT_TRUE(outlineOf(demo("blob:5"), Outline::none).empty());
}

TEST(Outline, ACurvilinearBlockHasTwelveCurves)
{
	const int n = 16;
	const auto segments = outlineOf(demo("shell:16"), Outline::box);
	EXPECT_EQ(segments.size(), 12u * n);
	// Four radii of length 2; arcs about the poles and along the longitudes 0 and pi, of radii 1 and 3 each.
	const double latitude = 0.45 * std::acos(-1.0);
	const double arcs = 2 * (1.0 + 3.0) * std::cos(latitude) * std::acos(-1.0) + 2 * (1.0 + 3.0) * 2 * latitude;
	EXPECT_NEAR(length(segments), 4 * 2.0 + arcs, 0.01 * arcs);
}

TEST(Outline, FeatureEdgesOfABoxAreItsTwelve)
{
	for (const char* name : {"blob:4", "graded:4"})
	{
		const auto segments = outlineOf(demo(name), Outline::edges);
		EXPECT_EQ(segments.size(), 12u * 4) << name;
		EXPECT_NEAR(length(segments), 12 * 6.0, 1e-9) << name;
	}
	// Four shapes of cells, and still a box.
	EXPECT_NEAR(length(outlineOf(demo("mixed:6"), Outline::edges)), 12 * 6.0, 1e-9);
}

TEST(Outline, FeatureEdgesDoNotDependOnTheGridsKind)
{
	const double shell = length(outlineOf(demo("shell:24"), Outline::edges));
	EXPECT_NEAR(shell, length(outlineOf(demo("shell:24"), Outline::box)), 1e-9);
	EXPECT_NEAR(shell, length(outlineOf(demo("hexes:24"), Outline::edges)), 1e-9);
	EXPECT_NEAR(shell, length(outlineOf(demo("tets:24"), Outline::edges)), 1e-9);
}

TEST(Outline, TheExtentHoldsEveryPointClosely)
{
	for (const char* name : {"shell:24", "hexes:24", "blob:4"})
	{
		const grid::BlockSet blocks = demo(name);
		const auto extent = extentOf(blocks);
		std::visit(
		    [&](const auto& grid)
		    {
			    for (const Vec3& direction :
			         {Vec3(1, 0, 0), Vec3(0.6, 0.8, 0), Vec3(-0.6, 0, 0.8), Vec3(0.48, -0.6, 0.64)})
			    {
				    double of_points = -1e300;
				    for (PointId p = 0; p < grid.pointCount(); ++p)
					    of_points = std::max(of_points, glm::dot(direction, grid.point(p)));
				    double of_extent = -1e300;
				    for (const Vec3& p : extent)
					    of_extent = std::max(of_extent, glm::dot(direction, p));
				    EXPECT_GE(of_extent, of_points - 1e-9) << name;
				    EXPECT_LE(of_extent, of_points + 1e-9) << name;
			    }
		    },
		    blocks.blocks[0].grid);
	}
}

} // namespace vp::render
