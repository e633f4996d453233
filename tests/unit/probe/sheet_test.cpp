#include "probe/sheet.h"

#include "exhaustive.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

void expectFrame(const probe::Sheet& sheet)
{
	EXPECT_NEAR(glm::length(sheet.normal), 1.0, 1e-14);
	EXPECT_NEAR(glm::length(sheet.up), 1.0, 1e-14);
	EXPECT_NEAR(glm::length(sheet.xAxis()), 1.0, 1e-14);
	EXPECT_NEAR(glm::dot(sheet.normal, sheet.up), 0.0, 1e-10);
	// x, y (up) and the normal are right-handed.
	EXPECT_NEAR(glm::length(glm::cross(sheet.xAxis(), sheet.up) - sheet.normal), 0.0, 1e-9);
}

} // namespace

TEST(Sheet, FrameOfAnyNormalAndUp)
{
	std::mt19937 random(1);
	for (int i = 0; i < 200; ++i)
	{
		const Vec3 normal = randomDirection(random);
		const Vec3 up = randomDirection(random);
		const probe::Sheet sheet = probe::makeSheet({1.0, 2.0, 3.0}, 7.0 * normal, 3.0 * up);
		expectFrame(sheet);
		EXPECT_EQ(sheet.origin, Vec3(1.0, 2.0, 3.0));
		EXPECT_NEAR(glm::length(sheet.normal - normal), 0.0, 1e-14); // its side is kept
		EXPECT_GT(glm::dot(sheet.up, up), 0.0);
		EXPECT_NEAR(glm::dot(sheet.up, glm::cross(normal, up)), 0.0, 1e-9); // in the plane of the two
	}
}

TEST(Sheet, TheDefaultUpIsY)
{
	const probe::Sheet z = probe::makeSheet(Vec3(0.0), {0.0, 0.0, 1.0});
	EXPECT_EQ(z.up, Vec3(0.0, 1.0, 0.0));
	EXPECT_EQ(z.xAxis(), Vec3(1.0, 0.0, 0.0));
}

TEST(Sheet, XStandsInForAParallelUp)
{
	for (const double sign : {1.0, -1.0})
	{
		const probe::Sheet y = probe::makeSheet(Vec3(0.0), {0.0, sign, 0.0});
		EXPECT_EQ(y.up, Vec3(1.0, 0.0, 0.0));
		expectFrame(y);
		const probe::Sheet x = probe::makeSheet(Vec3(0.0), {sign, 0.0, 0.0}, {-2.0, 0.0, 0.0});
		EXPECT_EQ(x.up, Vec3(0.0, 1.0, 0.0));
		expectFrame(x);
		expectFrame(probe::makeSheet(Vec3(0.0), {1.0, 2.0, 3.0}, {sign, 2.0 * sign, 3.0 * sign}));
		expectFrame(probe::makeSheet(Vec3(0.0), {1.0, 2.0, 3.0}, Vec3(0.0)));
	}
}

TEST(Sheet, LengthsDoNotMatter)
{
	for (const double length : {1e-300, 1e-160, 1e160, 1e300})
	{
		const probe::Sheet sheet = probe::makeSheet(Vec3(0.0), Vec3(length), {0.0, 1.0, 0.0});
		expectFrame(sheet);
		expectFrame(probe::makeSheet(Vec3(0.0), {0.0, 0.0, 1.0}, Vec3(length)));
	}
}

TEST(Sheet, ItsPlaneIsCanonical)
{
	const probe::Sheet sheet = probe::makeSheet({1.0, 2.0, 3.0}, {0.0, 0.0, -5.0});
	EXPECT_EQ(sheet.normal, Vec3(0.0, 0.0, -1.0));
	EXPECT_EQ(sheet.plane().normal(), Vec3(0.0, 0.0, 1.0));
	EXPECT_EQ(sheet.plane().origin(), sheet.origin);
}

} // namespace vp::test
