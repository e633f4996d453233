#include "interact/camera_moves.h"

#include "scenes.h"

#include <algorithm>

namespace vp::test
{

using interact::NamedView;
using render::Camera;

namespace
{

// Unit vectors at right angles, and everything of the scene beyond the near plane, if the eye is outside of it.
void expectSound(const Camera& camera, const Scene& scene)
{
	const double size = scene.bounds.diagonal();
	EXPECT_NEAR(glm::length(camera.up), 1.0, 1e-9);
	EXPECT_NEAR(glm::dot(camera.up, camera.forward()), 0.0, 1e-6);
	EXPECT_GT(camera.near, 0.0);
	EXPECT_EQ(camera.vertical_field, scene.view.camera.vertical_field);
	double nearest = 1e300;
	for (const Vec3& p : scene.corners())
		nearest = std::min(nearest, glm::dot(p - camera.position, camera.forward()));
	if (nearest > 0.01 * size)
	{
		EXPECT_NEAR(camera.near, 0.5 * nearest, 1e-6 * size);
	}
}

Pixel seen(const Camera& camera, const Scene& scene, const Vec3& p)
{
	return camera.project(p, scene.view.frame);
}

} // namespace

TEST(CameraMoves, PanKeepsThePointUnderThePointer)
{
	std::mt19937 random(1);
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		const auto corners = scene.corners();
		const Pixel from = somePixel(scene.view, random);
		const Pixel to = somePixel(scene.view, random);
		const Camera camera = interact::panned(scene.view, from, to, corners);
		expectSound(camera, scene);
		const Vec3 focal = scene.view.camera.focal_point;
		const Vec3 at_focal = interact::rayOf(scene.view, from).at(interact::depthOf(scene.view, focal));
		EXPECT_LT(glm::length(seen(camera, scene, at_focal) - to), 1e-3);
		for (const Vec3& point : corners)
		{
			const Camera by_point =
			    interact::panned(scene.view, scene.view.camera.project(point, scene.view.frame), to, corners, point);
			EXPECT_LT(glm::length(seen(by_point, scene, point) - to), 1e-3);
			EXPECT_NEAR(glm::length(by_point.focal_point - by_point.position),
			            glm::length(focal - scene.view.camera.position), 1e-7);
		}
		EXPECT_EQ(interact::panned(scene.view, from, from, corners).position, scene.view.camera.position);
	}
}

TEST(CameraMoves, ZoomKeepsThePointUnderThePointerAndIsBounded)
{
	std::mt19937 random(2);
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		const auto corners = scene.corners();
		const double distance = glm::length(scene.view.camera.focal_point - scene.view.camera.position);
		for (const Vec3& point : corners)
		{
			const Pixel pixel = scene.view.camera.project(point, scene.view.frame);
			const double factor = uniform(0.3, 3.0, random);
			const Camera camera = interact::zoomed(scene.view, pixel, factor, corners, point);
			expectSound(camera, scene);
			EXPECT_LT(glm::length(seen(camera, scene, point) - pixel), 1e-3);
			EXPECT_LT(glm::length(camera.forward() - scene.view.camera.forward()), 1e-7);
			EXPECT_NEAR(glm::length(camera.focal_point - camera.position), distance / factor, 1e-6);
		}
		interact::View view = scene.view;
		for (int i = 0; i < 400; ++i)
			view.camera = interact::zoomed(view, {640.0, 360.0}, 2.0, corners);
		EXPECT_GE(glm::length(view.camera.focal_point - view.camera.position), 0.9e-6 * scene.bounds.diagonal());
		EXPECT_LT(glm::length(view.camera.forward() - scene.view.camera.forward()), 1e-2);
		for (int i = 0; i < 400; ++i)
			view.camera = interact::zoomed(view, {640.0, 360.0}, 0.5, corners);
		EXPECT_NEAR(glm::length(view.camera.focal_point - view.camera.position), 100.0 * scene.bounds.diagonal(),
		            1e-2 * scene.bounds.diagonal());
	}
}

TEST(CameraMoves, TurnsKeepThePivotWhereItIs)
{
	std::mt19937 random(3);
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		const auto corners = scene.corners();
		for (const bool table : {false, true})
			for (const Vec3& pivot : corners)
			{
				const Pixel from = somePixel(scene.view, random);
				const Pixel to = somePixel(scene.view, random);
				const interact::TurnOptions options{pivot, table ? std::optional(Vec3(0.0, 0.0, 1.0)) : std::nullopt};
				const Camera& first = scene.view.camera;
				const Camera camera = interact::turned(scene.view, from, to, corners, options);
				expectSound(camera, scene);
				EXPECT_NEAR(glm::length(pivot - camera.position), glm::length(pivot - first.position), 1e-6);
				EXPECT_LT(glm::length(seen(camera, scene, pivot) - seen(first, scene, pivot)), 1e-2);
				EXPECT_NEAR(glm::length(camera.focal_point - camera.position),
				            glm::length(first.focal_point - first.position), 1e-6);
				EXPECT_EQ(interact::turned(scene.view, from, from, corners, options).position, first.position);
				const Camera again = interact::turned(scene.view, from, to, corners, options);
				EXPECT_EQ(again.position, camera.position);
				EXPECT_EQ(again.up, camera.up);
			}
	}
}

TEST(CameraMoves, TheSceneFollowsThePointer)
{
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		const Camera& first = scene.view.camera;
		const Vec3 front = first.focal_point - 0.5 * scene.bounds.diagonal() * first.forward();
		for (const Pixel& way : {Pixel(30.0, 0.0), Pixel(-30.0, 0.0), Pixel(0.0, 30.0), Pixel(0.0, -30.0)})
			for (const auto& pole : {std::optional<Vec3>(), std::optional(first.up)})
			{
				const Camera camera = interact::turned(scene.view, {640.0, 360.0}, Pixel(640.0, 360.0) + way,
				                                       scene.corners(), {{}, pole});
				EXPECT_GT(glm::dot(seen(camera, scene, front) - seen(first, scene, front), way), 0.0);
			}
	}
}

TEST(CameraMoves, ATurntableStaysUpright)
{
	std::mt19937 random(4);
	const Vec3 pole(0.0, 0.0, 1.0);
	for (Scene scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		for (int i = 0; i < 50; ++i)
		{
			const bool upright = std::abs(scene.view.camera.right().z) < 1e-9 && scene.view.camera.trueUp().z > 0.0;
			scene.view.camera = interact::turned(scene.view, somePixel(scene.view, random),
			                                     somePixel(scene.view, random), scene.corners(), {{}, pole});
			// A camera that was upright stays so, short of the poles.
			if (upright)
			{
				EXPECT_NEAR(scene.view.camera.right().z, 0.0, 1e-9);
				EXPECT_GT(scene.view.camera.trueUp().z, 0.0);
				EXPECT_LE(std::abs(scene.view.camera.forward().z), std::cos(0.49 * std::numbers::pi / 180.0));
			}
		}
	}
}

TEST(CameraMoves, RollsTurnThePicture)
{
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		const Camera& first = scene.view.camera;
		const Camera rolled = interact::rolled(first, 30.0);
		EXPECT_EQ(rolled.position, first.position);
		EXPECT_EQ(rolled.focal_point, first.focal_point);
		const Pixel middle(640.0, 360.0);
		const Pixel before = seen(first, scene, scene.corners()[0]) - middle;
		const Pixel after = seen(rolled, scene, scene.corners()[0]) - middle;
		EXPECT_NEAR(glm::length(after), glm::length(before), 1e-2);
		// Counter-clockwise where y is down.
		const double cross = before.x * after.y - before.y * after.x;
		EXPECT_NEAR(cross, -0.5 * glm::dot(before, before), 1e-2 * glm::length(before));
	}
}

TEST(CameraMoves, ViewsFillTheFreeAreaAndKeepTheField)
{
	for (Scene scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		scene.view.camera.vertical_field = 40.0;
		const auto corners = scene.corners();
		const probe::Sheet sheet = probe::placed(scene.probe).sheets[0];
		std::vector<Camera> cameras{interact::fitted(scene.view, corners)};
		EXPECT_LT(glm::length(cameras[0].forward() - scene.view.camera.forward()), 1e-6);
		EXPECT_LT(glm::length(cameras[0].trueUp() - scene.view.camera.trueUp()), 1e-6);
		for (int name = 0; name < interact::kNamedViews; ++name)
			cameras.push_back(interact::namedView(scene.view, static_cast<NamedView>(name), corners));
		EXPECT_NEAR(cameras[1].forward().x, -1.0, 1e-9);
		EXPECT_NEAR(cameras[4].forward().y, 1.0, 1e-9);
		EXPECT_NEAR(cameras[5].forward().z, -1.0, 1e-9);
		const render::Frame& frame = scene.view.frame;
		for (const Camera& camera : cameras)
		{
			expectSound(camera, scene);
			Pixel lo(1e300);
			Pixel hi(-1e300);
			for (const Vec3& p : corners)
			{
				lo = glm::min(lo, seen(camera, scene, p));
				hi = glm::max(hi, seen(camera, scene, p));
			}
			EXPECT_GT(std::min(lo.x - frame.free_lo.x, lo.y - frame.free_lo.y), -0.1);
			EXPECT_GT(std::min(frame.free_hi.x - hi.x, frame.free_hi.y - hi.y), -0.1);
			EXPECT_LT(std::min(lo.x - frame.free_lo.x, lo.y - frame.free_lo.y), 1.0);
		}
	}
}

TEST(CameraMoves, FacingASheetItsWindowFillsThePicture)
{
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		const auto corners = scene.corners();
		const probe::Sheet sheet = probe::placed(scene.probe).sheets[0];
		if (sheet.window && sheet.window->width() < 1e-10 * glm::length(sheet.origin))
			continue; // so near a place so far off, directions are as coarse as numbers are
		const Camera camera = interact::faceSheet(scene.view, sheet, corners);
		expectSound(camera, scene);
		EXPECT_NEAR(glm::dot(camera.forward(), sheet.normal), -1.0, 1e-9);
		EXPECT_NEAR(glm::dot(camera.trueUp(), sheet.up), 1.0, 1e-9);
		Camera near_all = camera;
		near_all.fitNear(corners);
		if (!sheet.window)
			continue;
		EXPECT_EQ(camera.near, near_all.near);
		const auto window = interact::windowCorners(sheet);
		const Pixel lo = seen(camera, scene, window[3]);
		const Pixel hi = seen(camera, scene, window[1]);
		const render::Frame& frame = scene.view.frame;
		const double tolerance = 1e-8 / sheet.window->width() * 1280.0 + 0.1; // far off, places are that coarse
		EXPECT_LT(std::min(hi.x - frame.free_hi.x, hi.y - frame.free_hi.y), tolerance);
		const Pixel room = (frame.free_hi - frame.free_lo) - (hi - lo);
		EXPECT_GT(std::min(room.x, room.y), -tolerance);
		EXPECT_LT(std::min(room.x, room.y), tolerance);
	}
}

} // namespace vp::test
