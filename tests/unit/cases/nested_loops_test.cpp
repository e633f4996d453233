#include "cases/nested_loops.h"

#include "base/cross2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace vp::cases
{
namespace
{

using glm::dvec2;

// Loops as a cut, with the number of a place as its edge's positive end.
struct Loops
{
	CellCut cut;
	std::vector<dvec2> places;

	Loops() { cut.starts.push_back(0); }
	void add(const std::vector<dvec2>& loop)
	{
		for (const dvec2& p : loop)
		{
			cut.edges.push_back({static_cast<std::uint16_t>(places.size()), 0});
			places.push_back(p);
		}
		cut.starts.push_back(static_cast<std::uint32_t>(cut.edges.size()));
	}
	void join() { joinNestedLoops(cut, places); }
	double area(int loop) const
	{
		double twice = 0.0;
		const std::uint32_t begin = cut.starts[loop];
		const std::uint32_t end = cut.starts[loop + 1];
		for (std::uint32_t e = begin; e < end; ++e)
			twice += cross(places[cut.edges[e].positive], places[cut.edges[e + 1 < end ? e + 1 : begin].positive]);
		return 0.5 * std::abs(twice);
	}
	double area() const
	{
		double sum = 0.0;
		for (int loop = 0; loop < cut.polygons(); ++loop)
			sum += area(loop);
		return sum;
	}
	// Returns true if a side of a loop crosses another side.
	bool crosses() const
	{
		for (int loop = 0; loop < cut.polygons(); ++loop)
		{
			const std::uint32_t n = cut.starts[loop + 1] - cut.starts[loop];
			const auto at = [&](std::uint32_t i) { return places[cut.edges[cut.starts[loop] + i % n].positive]; };
			const auto turn = [](const dvec2& a, const dvec2& b, const dvec2& c) { return cross(b - a, c - a); };
			for (std::uint32_t i = 0; i < n; ++i)
				for (std::uint32_t j = 0; j < i; ++j)
					if (turn(at(i), at(i + 1), at(j)) * turn(at(i), at(i + 1), at(j + 1)) < -1e-18 &&
					    turn(at(j), at(j + 1), at(i)) * turn(at(j), at(j + 1), at(i + 1)) < -1e-18)
						return true;
		}
		return false;
	}
};

std::vector<dvec2> square(const dvec2& lo, double size, bool clockwise = false)
{
	std::vector<dvec2> loop{lo, lo + dvec2(size, 0), lo + dvec2(size), lo + dvec2(0, size)};
	if (clockwise)
		std::ranges::reverse(loop);
	return loop;
}

// Neither the sense of a loop nor the order of the loops tells which one is a hole.
TEST(NestedLoops, ARingIsOnePolygon)
{
	for (int way = 0; way < 8; ++way)
	{
		Loops loops;
		if (way & 1)
			loops.add(square({1, 1}, 1, way & 2));
		loops.add(square({0, 0}, 3, way & 4));
		if (!(way & 1))
			loops.add(square({1, 1}, 1, way & 2));
		loops.join();
		ASSERT_EQ(loops.cut.polygons(), 1) << way;
		EXPECT_EQ(loops.cut.edges.size(), 10u);
		EXPECT_DOUBLE_EQ(loops.area(), 8.0);
		EXPECT_FALSE(loops.crosses());
	}
}

TEST(NestedLoops, IslandsAndNeighborsAreTheirOwn)
{
	Loops loops;
	loops.add(square({0, 0}, 9));
	loops.add(square({1, 1}, 3));
	loops.add(square({2, 2}, 1)); // in the hole
	loops.add(square({5, 1}, 3));
	loops.add(square({20, 0}, 2));
	loops.join();
	EXPECT_EQ(loops.cut.polygons(), 3);
	EXPECT_DOUBLE_EQ(loops.area(), 81.0 - 9.0 - 9.0 + 1.0 + 4.0);
	EXPECT_FALSE(loops.crosses());
}

TEST(NestedLoops, WhatCrossesOrHasNoAreaStays)
{
	Loops crossing;
	crossing.add(square({0, 0}, 3));
	crossing.add(square({2, 1}, 3));
	crossing.join();
	EXPECT_EQ(crossing.cut.polygons(), 2);
	EXPECT_EQ(crossing.cut.edges.size(), 8u);
	Loops touched;
	touched.add(square({0, 0}, 3));
	touched.add({{1, 1}, {1, 1}, {1, 1}});
	touched.join();
	EXPECT_EQ(touched.cut.polygons(), 2);
}

// The hole's corner lies on the rim's corner or side.
TEST(NestedLoops, HolesMayTouchTheRim)
{
	for (const dvec2& lo : {dvec2(0, 0), dvec2(0, 1), dvec2(2, 2), dvec2(1, 0)})
	{
		Loops loops;
		loops.add(square({0, 0}, 3));
		loops.add({lo, lo + dvec2(1, 0.25), lo + dvec2(0.25, 1)});
		loops.join();
		EXPECT_EQ(loops.cut.polygons(), 1);
		EXPECT_NEAR(loops.area(), 9.0 - 0.5 * (1.0 - 0.0625), 1e-14);
	}
}

// Stars in the places of a lattice, some in a rim that is a star itself.
TEST(NestedLoops, ManyHolesOfAnyForm)
{
	std::mt19937 random(5);
	const auto real = [&](double low, double high)
	{ return std::uniform_real_distribution<double>(low, high)(random); };
	const auto star = [&](const dvec2& middle, double least, double most, int corners)
	{
		std::vector<dvec2> loop;
		const double begin = real(0.0, 1.0);
		for (int i = 0; i < corners; ++i)
		{
			const double angle = begin + 2.0 * std::numbers::pi * i / corners;
			loop.push_back(middle + real(least, most) * dvec2(std::cos(angle), std::sin(angle)));
		}
		return loop;
	};
	for (int round = 0; round < 100; ++round)
	{
		Loops loops;
		loops.add(star({0, 0}, 5.0, 9.0, 40));
		double expected = loops.area(0);
		int holes = 0;
		for (int x = -3; x < 3; ++x)
			for (int y = -3; y < 3; ++y)
				if (real(0.0, 1.0) < 0.5)
				{
					loops.add(star({x + 0.5, y + 0.5}, 0.1, 0.45, 3 + static_cast<int>(random() % 9)));
					expected -= loops.area(++holes);
				}
		loops.join();
		ASSERT_EQ(loops.cut.polygons(), 1);
		EXPECT_NEAR(loops.area(), expected, 1e-12 * expected);
		EXPECT_FALSE(loops.crosses()) << round;
	}
}

} // namespace
} // namespace vp::cases
