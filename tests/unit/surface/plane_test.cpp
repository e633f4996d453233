#include "surface/plane.h"

#include "exhaustive.h"

#include <gtest/gtest.h>

namespace vp::test
{

using surface::Plane;

TEST(Plane, ItsNormalIsCanonical)
{
	EXPECT_EQ(Plane(Vec3(0.0), {0.0, 0.0, -2.0}).normal(), Vec3(0.0, 0.0, 1.0));
	EXPECT_LT(glm::length(Plane(Vec3(0.0), {0.0, -3.0, 4.0}).normal() - Vec3(0.0, 0.6, -0.8)), 1e-15);
	EXPECT_EQ(Plane(Vec3(0.0), {-0.0, 0.0, 5.0}).normal(), Vec3(0.0, 0.0, 1.0));
	std::mt19937 random(1);
	for (int i = 0; i < 100; ++i)
	{
		const Vec3 normal = randomDirection(random);
		const Plane plane(Vec3(0.0), normal);
		EXPECT_EQ(plane.normal(), Plane(Vec3(0.0), -normal).normal());
		EXPECT_GT(plane.normal().x, 0.0);
		EXPECT_NEAR(glm::length(plane.normal()), 1.0, 1e-15);
		EXPECT_NEAR(std::abs(glm::dot(plane.normal(), normal)), 1.0, 1e-15);
	}
}

TEST(Plane, TheLengthOfTheNormalDoesNotMatter)
{
	for (const double length : {5e-324, 1e-300, 1e-160, 1e160, 1e308})
	{
		const Plane plane(Vec3(0.0), Vec3(length, 0.0, -length));
		EXPECT_NEAR(plane.normal().x, std::sqrt(0.5), 1e-15) << length;
		EXPECT_NEAR(plane.normal().z, -std::sqrt(0.5), 1e-15) << length;
	}
}

TEST(Plane, AVertexOnItCountsAsPositive)
{
	for (const double sign : {1.0, -1.0})
	{
		const Plane plane({3.0, 0.0, 0.0}, {sign, 0.0, 0.0});
		EXPECT_EQ(plane.signedDistance({3.0, 7.0, -2.0}), 0.0);
		EXPECT_GT(plane.signedDistance({3.0 + 1e-15, 0.0, 0.0}), 0.0);
		EXPECT_LT(plane.signedDistance({3.0 - 1e-15, 0.0, 0.0}), 0.0);
	}
}

TEST(Plane, MeetsTheBoxesItPassesThrough)
{
	std::mt19937 random(2);
	const Box space{Vec3(-5.0), Vec3(5.0)};
	int met = 0;
	for (int i = 0; i < 2000; ++i)
	{
		Box box;
		box.include(randomPoint(space, random));
		box.include(randomPoint(space, random));
		const Plane plane(randomPoint(space, random), randomDirection(random));
		double lowest = std::numeric_limits<double>::infinity();
		double highest = -lowest;
		for (int corner = 0; corner < 8; ++corner)
		{
			const double distance = plane.signedDistance(
			    {corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y, corner & 4 ? box.hi.z : box.lo.z});
			lowest = std::min(lowest, distance);
			highest = std::max(highest, distance);
		}
		EXPECT_EQ(plane.meets(box), lowest <= 0.0 && highest >= 0.0);
		met += plane.meets(box);
	}
	EXPECT_GT(met, 200);
	EXPECT_LT(met, 1800);
}

TEST(Plane, MeetsABoxItOnlyTouches)
{
	std::mt19937 random(3);
	const Box space{Vec3(-5.0), Vec3(5.0)};
	for (int i = 0; i < 200; ++i)
	{
		Box box;
		box.include(randomPoint(space, random));
		box.include(randomPoint(space, random));
		EXPECT_TRUE(Plane(box.lo, {1.0, 0.0, 0.0}).meets(box));
		EXPECT_TRUE(Plane(box.hi, {0.0, 0.0, 1.0}).meets(box));
		EXPECT_TRUE(Plane(box.hi, {1.0, 2.0, 3.0}).meets(box));
		EXPECT_TRUE(Plane(box.lo, {1.0, 2.0, 3.0}).meets({box.lo, box.lo}));
	}
}

} // namespace vp::test
