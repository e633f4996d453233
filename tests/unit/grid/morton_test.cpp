#include "grid/link/morton.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace vp::grid
{
namespace
{

TEST(Morton, OrdersOctantsFirst)
{
	Box box;
	box.include(Vec3(0.0));
	box.include(Vec3(8.0));
	const MortonCurve curve(box);
	EXPECT_EQ(curve(Vec3(0.0)), 0u);
	EXPECT_LT(curve(Vec3(3.9, 3.9, 3.9)), curve(Vec3(4.1, 0.0, 0.0)));
	EXPECT_LT(curve(Vec3(7.0, 3.9, 3.9)), curve(Vec3(0.0, 4.1, 0.0)));
	EXPECT_LT(curve(Vec3(7.0, 7.0, 3.9)), curve(Vec3(0.0, 0.0, 4.1)));
	EXPECT_LE(curve(Vec3(8.0)), MortonCurve::kLast);
	EXPECT_LT(curve(Vec3(0.0)), curve(Vec3(8.0 / (1 << 20), 0.0, 0.0)));
}

TEST(Morton, TakesAnyNumber)
{
	const double inf = std::numeric_limits<double>::infinity();
	Box box;
	box.include(Vec3(-1e308));
	box.include(Vec3(1e308));
	for (const MortonCurve& curve : {MortonCurve(Box{}), MortonCurve(box)})
	{
		EXPECT_EQ(curve(Vec3(std::nan(""), 0.0, 0.0)), MortonCurve::kLast);
		for (const Vec3& p : {Vec3(inf), Vec3(-inf), Vec3(0.0), Vec3(1e308)})
			EXPECT_LE(curve(p), MortonCurve::kLast);
	}
}

TEST(Morton, SortIsStableAndKeepsEveryId)
{
	std::mt19937_64 random(1);
	for (const std::size_t count : {0u, 1u, 2u, 1000u, 300000u})
		for (const int bits : {0, 5, 40, 64})
		{
			std::vector<KeyedId> expected(count);
			for (std::size_t i = 0; i < count; ++i)
				expected[i] = {bits == 0 ? 7 : random() >> (64 - bits), static_cast<std::uint32_t>(i)};
			KeyedIds items(expected.begin(), expected.end());
			std::ranges::stable_sort(expected, {}, &KeyedId::key);
			sortByKey(items);
			for (std::size_t i = 0; i < count; ++i)
			{
				ASSERT_EQ(items[i].key, expected[i].key);
				ASSERT_EQ(items[i].id, expected[i].id);
			}
		}
}

} // namespace
} // namespace vp::grid
