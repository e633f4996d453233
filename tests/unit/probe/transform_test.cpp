#include "random_probes.h"

namespace vp::test
{

using probe::Frame;
using probe::Transform;

namespace
{

Transform randomTransform(std::mt19937& random)
{
	Transform transform;
	for (Vec3& row : transform.row)
		row = randomPoint({Vec3(-1.0), Vec3(1.0)}, random);
	for (int axis = 0; axis < 3; ++axis)
		transform.row[axis][axis] += 3.0; // far from singular
	return transform;
}

} // namespace

TEST(Transform, AProductAppliesTheFirstFactorFirst)
{
	const Transform doubles{{Vec3(2.0, 0.0, 0.0), Vec3(0.0, 2.0, 0.0), Vec3(0.0, 0.0, 2.0), Vec3(0.0)}};
	Transform shifts;
	shifts.row[3] = {1.0, 10.0, 100.0};
	EXPECT_EQ((doubles * shifts).point({1.0, 1.0, 1.0}), Vec3(3.0, 12.0, 102.0));
	EXPECT_EQ((shifts * doubles).point({1.0, 1.0, 1.0}), Vec3(4.0, 22.0, 202.0));
}

TEST(Transform, ProductIsComposition)
{
	std::mt19937 random(2);
	for (int i = 0; i < 200; ++i)
	{
		const Transform a = randomTransform(random);
		const Transform b = randomTransform(random);
		const Vec3 p = randomPoint({Vec3(-9.0), Vec3(9.0)}, random);
		expectNear((a * b).point(p), b.point(a.point(p)), 1e-12);
		expectNear((a * b).vector(p), b.vector(a.vector(p)), 1e-12);
		expectNear(inverse(a * b), inverse(b) * inverse(a), 1e-13);
	}
}

TEST(Transform, GlmsMatrixIsTheSameMap)
{
	std::mt19937 random(3);
	const Transform a = randomTransform(random);
	const Transform b = randomTransform(random);
	const Vec3 p{1.0, -2.0, 3.0};
	expectNear(Vec3(a.glmMatrix() * glm::dvec4(p, 1.0)), a.point(p), 1e-14);
	expectNear(Vec3(b.glmMatrix() * a.glmMatrix() * glm::dvec4(p, 1.0)), (a * b).point(p),
	           1e-13);                           // the other way round
	EXPECT_EQ(Vec3(a.glmMatrix()[3]), a.row[3]); // the bottom row is GLM's last column
}

TEST(Transform, InverseUndoes)
{
	std::mt19937 random(4);
	for (int i = 0; i < 200; ++i)
	{
		const Transform a = randomTransform(random);
		expectNear(a * inverse(a), Transform(), 1e-14);
		expectNear(inverse(a) * a, Transform(), 1e-14);
	}
}

TEST(Frame, MapsItsAxesToXYZ)
{
	std::mt19937 random(5);
	for (int i = 0; i < 200; ++i)
	{
		const Frame frame = randomFrame(random);
		const Transform to = toFrame(frame);
		expectNear(to.point(frame.origin), Vec3(0.0), 1e-14);
		expectNear(to.vector(frame.xAxis()), {1.0, 0.0, 0.0}, 1e-15);
		expectNear(to.vector(frame.up), {0.0, 1.0, 0.0}, 1e-15);
		expectNear(to.vector(frame.normal), {0.0, 0.0, 1.0}, 1e-15);
		expectNear(inverse(to), fromFrame(frame), 1e-13);
		EXPECT_EQ(fromFrame(frame).row[3], frame.origin);
	}
}

// A frame that is written to a file and read again must not drift.
TEST(Frame, MakingItAgainChangesNoBit)
{
	std::mt19937 random(6);
	for (int i = 0; i < 20000; ++i)
	{
		Frame frame = randomFrame(random);
		if (i % 2) // an up all but parallel to the normal
			frame = probe::makeFrame(frame.origin, frame.normal, frame.normal + 1e-5 * frame.up);
		EXPECT_EQ(probe::makeFrame(frame.origin, frame.normal, frame.up), frame);
		EXPECT_LT(std::abs(glm::dot(frame.normal, frame.up)), 1e-15);
	}
}

TEST(Frame, TurnsCounterClockwise)
{
	const Frame still;
	const Vec3 y(0.0, 1.0, 0.0);
	// Quarter turns are exact: z goes to x, to -z, to -x about y.
	EXPECT_EQ(turned(still, Vec3(0.0), y, 90.0).normal, Vec3(1.0, 0.0, 0.0));
	EXPECT_EQ(turned(still, Vec3(0.0), y, 180.0).normal, Vec3(0.0, 0.0, -1.0));
	EXPECT_EQ(turned(still, Vec3(0.0), y, -90.0).normal, Vec3(-1.0, 0.0, 0.0));
	EXPECT_EQ(turned(still, Vec3(0.0), y, 360.0 * 7), still);
	EXPECT_EQ(turned(still, {5.0, 0.0, 0.0}, 1e200 * y, 90.0).origin, Vec3(5.0, 0.0, 5.0));
	for (int degrees = -720; degrees <= 720; ++degrees)
	{
		const double angle = degrees * std::numbers::pi / 180.0;
		expectNear(turned(still, Vec3(0.0), y, degrees).normal, {std::sin(angle), 0.0, std::cos(angle)}, 3e-15);
	}
	expectNear(turned(still, Vec3(0.0), {0.0, 0.0, -2.0}, 30.0).up, {0.5, std::sqrt(0.75), 0.0}, 1e-15);
}

TEST(Frame, TurnsAddUp)
{
	std::mt19937 random(7);
	for (int i = 0; i < 200; ++i)
	{
		const Frame frame = randomFrame(random);
		const Vec3 through = randomPoint({Vec3(-5.0), Vec3(5.0)}, random);
		const Vec3 axis = randomDirection(random);
		const double a = between(-800.0, 800.0, random);
		const double b = between(-800.0, 800.0, random);
		const Frame both = turned(turned(frame, through, axis, a), through, axis, b);
		expectNear(both, turned(frame, through, 3.0 * axis, a + b), 1e-12);
		EXPECT_NEAR(glm::length(both.origin - through), glm::length(frame.origin - through), 1e-13);
		EXPECT_NEAR(glm::dot(both.normal, axis), glm::dot(frame.normal, axis), 1e-13);
		EXPECT_EQ(turned(frame, frame.origin, axis, a).origin, frame.origin);
	}
}

} // namespace vp::test
