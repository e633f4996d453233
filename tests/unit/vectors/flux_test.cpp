#include "launched.h"
#include "vectors/flux.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace vp::test
{

namespace
{

vectors::Flux fluxOf(const grid::BlockSet& blocks, const TestPlane& plane,
                     const std::optional<probe::Window>& window = {}, const char* array = "v")
{
	cut::Cutter cutter(blocks);
	const SlicedSheet sheet = cut(cutter, plane, {}, Search::fastest, window);
	return vectors::fluxThrough(blocks, sheet.mesh, vectors::chooseVectors(blocks, array).value());
}

} // namespace

// The vector (-y, x, 0.3) is linear: its integral is the window's area times the vector in the middle.
TEST(Flux, OfALinearFieldIsExact)
{
	for (const char* name : {"blob", "graded", "mixed"})
	{
		const grid::BlockSet blocks = demo(name, 7);
		const Vec3 origin(0.4, -0.3, 0.2);
		for (const Vec3& normal : {Vec3(0.0, 0.0, 1.0), Vec3(1.0, 0.0, 0.0), Vec3(-0.3, 0.5, 0.8)})
		{
			const double through = glm::dot(Vec3(-origin.y, origin.x, 0.3), glm::normalize(normal));
			const vectors::Flux flux = fluxOf(blocks, {origin, normal}, probe::centeredWindow(1.5, 0.8));
			EXPECT_NEAR(flux.through, 1.5 * 0.8 * through, 2e-6) << name; // arrays and points are of single precision
			EXPECT_EQ(flux.nan_area, 0.0);
		}
	}
}

// Half a ring from radius 1 to 3, about which the field turns: through z = 0 flows 0.3 times its area.
TEST(Flux, ThroughTheShellByTheFormula)
{
	const vectors::Flux flux = fluxOf(demo("shell", 64), {Vec3(0.0), {0.0, 0.0, 1.0}});
	EXPECT_NEAR(flux.through, 0.3 * 0.5 * std::numbers::pi * (9.0 - 1.0), 0.002);
	const vectors::Flux back = fluxOf(demo("shell", 64), {Vec3(0.0), {0.0, 0.0, -1.0}});
	EXPECT_NEAR(back.through, -flux.through, 1e-9);
}

TEST(Flux, OfCellsAndOfWhatIsNotKnown)
{
	grid::BlockSet blocks = demo("blob", 6);
	std::vector<double> values(3 * 6 * 6 * 6, 2.0);
	// The layer k = 3 that is cut: one cell of it holds no number.
	values[3 * (3 * 36 + 14) + 1] = std::numeric_limits<double>::quiet_NaN();
	blocks.blocks[0].fields.push_back(grid::makeField("c", grid::Association::cell, 3, std::move(values)));
	const vectors::Flux flux = fluxOf(blocks, {{0.0, 0.0, 0.4}, {0.0, 0.0, 1.0}}, {}, "c");
	EXPECT_NEAR(flux.through, 2.0 * 35.0, 1e-9);
	EXPECT_NEAR(flux.nan_area, 1.0, 1e-9);
}

} // namespace vp::test
