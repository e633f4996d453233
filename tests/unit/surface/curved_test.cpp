#include "surface/curved.h"
#include "surface/implicit_surface.h"

#include <gtest/gtest.h>

#include <random>

namespace vp::test
{

TEST(BlockSurface, CrossesAnEdgeAtOnePlaceFromBothEnds)
{
	std::mt19937 random(8);
	std::uniform_real_distribution<double> number(-1.0, 1.0);
	const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
	for (const char* text : {"sphere:0.7", "cone:30", "quadric:1,0.5,-2,0.3,-0.7,0.2,0.1,-0.4,0.6,-0.3",
	                         "z = 0.2*sin(5*x)", "sqrt(x) - y*z - 0.3"})
	{
		const surface::ImplicitSurface form = surface::ImplicitSurface::parse(text).value();
		const surface::BlockSurface placed(std::visit(
		    [](const auto& kind) -> surface::BlockSurface::Kind { return kind; }, form.placed(surface::Axes())));
		int crossed = 0;
		for (int i = 0; i < 2000; ++i)
		{
			const Vec3 a = vector();
			const Vec3 b = vector();
			const double height_a = *placed.heightAt(a);
			const double height_b = *placed.heightAt(b);
			if ((height_a >= 0.0) == (height_b >= 0.0))
				continue;
			++crossed;
			const double from_a = placed.crossing(a, b, height_a, height_b);
			const double from_b = placed.crossing(b, a, height_b, height_a);
			ASSERT_TRUE(from_a >= 0.0 && from_a <= 1.0);
			EXPECT_EQ(from_a, 1.0 - from_b) << text;
			EXPECT_EQ(from_b, 1.0 - from_a) << text;
		}
		EXPECT_GT(crossed, 100) << text;
	}
}

// On the way the height is exactly 1, which is no root.
TEST(BlockSurface, GoesOnToTheRoot)
{
	const surface::ImplicitSurface form = surface::ImplicitSurface::parse("min(1, 4*x - 1)").value();
	const surface::BlockSurface placed(
	    std::visit([](const auto& kind) -> surface::BlockSurface::Kind { return kind; }, form.placed(surface::Axes())));
	EXPECT_NEAR(placed.crossing(Vec3(0.0), Vec3(1.0, 0.0, 0.0), -1.0, 1.0), 0.25, 1e-14);
}

} // namespace vp::test
