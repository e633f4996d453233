#include "sliced_sheet.h"
#include "tries.h"

#include "grid/demo/demo.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

struct Work
{
	double cut = 0.0;
	double touched = 0.0;
	double hops = 0.0;
	double boundary_tests = 0.0;
};

Work workOf(cut::Cutter& cutter, const TestPlane& plane, const seed::SeedOptions& seeds = {})
{
	const SlicedSheet sheet = cut(cutter, plane, seeds);
	return {static_cast<double>(sheet.cutCellCount()), static_cast<double>(sheet.touched()),
	        static_cast<double>(sheet.slice.seeds.hops), static_cast<double>(sheet.slice.seeds.boundary_tests)};
}

double sideOf(const grid::BlockSet& set)
{
	return std::cbrt(static_cast<double>(set.cellCount()));
}

// Planes as the benchmark has them, and hot spots anywhere: many of those are outside.
std::vector<TestPlane> planesThrough(const Box& box)
{
	std::vector<TestPlane> planes = randomPlanes(box, tries(60), 120);
	planes.push_back({box.center(), {0.3, 0.5, 0.81}});
	planes.push_back({box.center(), {1.0, 0.0, 0.0}});
	planes.push_back({box.center(), {0.0, 1.0, 0.0}});
	planes.push_back({box.center(), {0.0, 0.0, 1.0}});
	return planes;
}

} // namespace

TEST(OutputSensitivity, WorkIsBoundedByTheCut)
{
	for (const auto& [name, n] :
	     {std::pair("shell", 16), std::pair("shell", 32), std::pair("shell", 64), std::pair("hexes", 32),
	      std::pair("tets", 20), std::pair("mixed", 24), std::pair("blob", 32), std::pair("graded", 32)})
	{
		const grid::BlockSet set = std::move(grid::makeDemo(name, n).value());
		cut::Cutter cutter(set);
		for (const TestPlane& plane : planesThrough(set.bounds()))
		{
			for (const bool lattice : {false, true})
			{
				const Work work = workOf(cutter, plane, {.lattice = lattice});
				EXPECT_LE(work.touched, 1.05 * work.cut + 1.0) << name << ' ' << n;
				EXPECT_LE(work.hops, work.cut / 5.0 + 6.0 * sideOf(set))
				    << name << ' ' << n << (lattice ? ", lattice" : "") << ", origin " << plane.origin.x << ' '
				    << plane.origin.y << ' ' << plane.origin.z;
			}
		}
	}
}

// A doubled grid has eight times the cells and four times the cut.
TEST(OutputSensitivity, WorkGrowsWithTheCut)
{
	for (const char* name : {"shell", "tets", "mixed"})
	{
		const int n = std::string(name) == "shell" ? 32 : 15;
		const grid::BlockSet coarse = std::move(grid::makeDemo(name, n).value());
		const grid::BlockSet fine = std::move(grid::makeDemo(name, 2 * n).value());
		cut::Cutter coarse_cutter(coarse);
		cut::Cutter fine_cutter(fine);
		Work small;
		Work large;
		const auto add = [](Work& sum, const Work& part)
		{
			sum.cut += part.cut;
			sum.touched += part.touched;
			sum.boundary_tests += part.boundary_tests;
		};
		for (const TestPlane& plane : planesThrough(coarse.bounds()))
		{
			add(small, workOf(coarse_cutter, plane));
			add(large, workOf(fine_cutter, plane));
		}
		EXPECT_NEAR(large.cut / small.cut, 4.0, 0.2) << name;
		EXPECT_LE(large.touched / small.touched, 4.2) << name;
		EXPECT_LE(large.boundary_tests / small.boundary_tests, 4.4) << name;
	}
}

} // namespace vp::test
