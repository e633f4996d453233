#include "interact/view.h"

#include "scenes.h"

namespace vp::test
{

TEST(View, APointLiesUnderItsPixel)
{
	std::mt19937 random(1);
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		for (int i = 0; i < 5; ++i)
		{
			const Pixel pixel = somePixel(scene.view, random);
			const double depth = uniform(1.01, 4.0, random) * scene.view.camera.near;
			const Vec3 point = interact::rayOf(scene.view, pixel).at(depth);
			EXPECT_NEAR(interact::depthOf(scene.view, point), depth, 1e-7);
			const auto seen = interact::pixelOf(scene.view, point);
			ASSERT_TRUE(seen);
			EXPECT_LT(glm::length(*seen - pixel), 1e-4);
			// A length across the line of sight.
			const double scale = interact::pixelsPerLength(scene.view, depth);
			const Vec3 beside = point + 0.01 * scene.view.camera.right();
			EXPECT_NEAR(glm::length(*interact::pixelOf(scene.view, beside) - *seen), 0.01 * scale, 1e-4);
		}
		EXPECT_FALSE(interact::pixelOf(scene.view, scene.view.camera.position - scene.view.camera.forward()));
	}
}

TEST(View, SegmentsAreSeenBeyondTheNearPlane)
{
	const Scene scene = allScenes()[3];
	const render::Camera& camera = scene.view.camera;
	const Vec3 front = interact::rayOf(scene.view, {400.0, 300.0}).at(2.0 * scene.view.camera.near);
	const Vec3 behind = camera.position - camera.forward() + 3.0 * camera.right();
	const auto seen = interact::seenSegment(scene.view, front, behind);
	ASSERT_TRUE(seen);
	EXPECT_LT(glm::length((*seen)[0] - Pixel(400.0, 300.0)), 1e-6);
	EXPECT_TRUE(std::isfinite((*seen)[1].x) && std::isfinite((*seen)[1].y));
	// The other end is further right than any that is seen from farther away.
	EXPECT_GT((*seen)[1].x, 400.0);
	const auto turned_round = interact::seenSegment(scene.view, behind, front);
	ASSERT_TRUE(turned_round);
	EXPECT_EQ((*turned_round)[0], (*seen)[1]);
	EXPECT_FALSE(interact::seenSegment(scene.view, behind, behind + camera.right()));
}

TEST(View, RaysMeetPlanesInFrontAlone)
{
	const interact::Ray ray{{0.0, 0.0, 5.0}, {0.0, 0.0, -1.0}};
	EXPECT_EQ(interact::depthOnPlane(ray, Vec3(0.0), {0.0, 0.0, 1.0}), 5.0);
	EXPECT_FALSE(interact::depthOnPlane(ray, {0.0, 0.0, 6.0}, {0.0, 0.0, 1.0}));
	EXPECT_FALSE(interact::depthOnPlane(ray, Vec3(0.0), {1.0, 0.0, 0.0}));
	EXPECT_FALSE(interact::depthOnPlane(ray, Vec3(1.0), {1.0, 0.0, 0.0}));
}

} // namespace vp::test
