#include "interact/drag.h"

#include "scenes.h"

#include <numbers>

namespace vp::test
{

using interact::Drag;

// Hard places: where a pixel means little, or too much.

// Straight at the eye an arrow has no length on screen: up is away from the eye, at the scale there.
TEST(Drag, AtTheEyeUpIsAway)
{
	for (const char* name : {"0 from z", "0 from sheet", "7 from z, far off"})
	{
		SCOPED_TRACE(name);
		Scene scene = sceneNamed(name);
		for (const double side : {1.0, -1.0})
		{
			scene.probe.frame.normal = Vec3(0.0, 0.0, side);
			const Drag drag({HandleKind::move, 2}, startOf(scene), scene.view, scene.probe, scene.bounds);
			const Vec3 origin = scene.probe.frame.origin;
			const double scale = interact::pixelsPerLength(scene.view, interact::depthOf(scene.view, origin));
			const auto moved = [&](const Pixel& way) { return drag.to(startOf(scene) + way).frame.origin - origin; };
			EXPECT_LT(glm::length(moved({0.0, -50.0}) - 50.0 / scale * scene.view.camera.forward()), 1e-6);
			EXPECT_LT(glm::length(moved({80.0, 30.0}) + 30.0 / scale * scene.view.camera.forward()), 1e-6);
		}
	}
}

// A ring seen edge on turns like a wheel under a hand: a quarter of it for as much of its length.
TEST(Drag, EdgeOnRingsTurnAlongTheirTangent)
{
	for (const char* name : {"0 from x", "0 from -y", "0 from x, far off"})
	{
		SCOPED_TRACE(name);
		const Scene scene = sceneNamed(name);
		const Vec3 axis(0.0, 0.0, 1.0);
		const Pixel start = startOf(scene);
		const Drag drag({HandleKind::turn, 2}, start, scene.view, scene.probe, scene.bounds, 2.0);
		const double quarter = 0.5 * std::numbers::pi * 2.0 * interact::kRingPixels;
		const probe::Probe turned = drag.to(start + Pixel(quarter, 123.0));
		EXPECT_NEAR(degreesBetween(turned.frame.up, scene.probe.frame.up), 90.0, 1e-6);
		// The side turned to the eye goes right, with the pointer.
		const Vec3 near = -glm::normalize(scene.view.camera.forward());
		const probe::Frame a_little =
		    probe::turned({scene.probe.frame.origin, near, axis}, scene.probe.frame.origin, axis, 1.0);
		EXPECT_GT(glm::dot(a_little.normal, scene.view.camera.right()), 0.0);
		EXPECT_NEAR(glm::dot(glm::cross(scene.probe.frame.up, turned.frame.up), axis), 1.0, 1e-6);
	}
}

// Beyond the horizon of a plane or an axis it goes on to the end on this side, not to the other side.
void expectNoJumpBeyondHorizons(Scene scene)
{
	scene.probe.frame = probe::makeFrame(scene.bounds.center(), {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0});
	const probe::Frame& frame = scene.probe.frame;
	const bool up_is_away = glm::dot(scene.view.camera.forward(), frame.up) > 0.0;
	const Vec3 away = up_is_away ? frame.up : -frame.up;
	for (const HandleKind kind : {HandleKind::move, HandleKind::corner})
	{
		const probe::Sheet sheet = probe::placed(scene.probe).sheets[0];
		const probe::Window& w = *sheet.window;
		const Vec3 taken =
		    kind == HandleKind::move ? frame.origin : interact::pointOn(sheet, {w.x1, up_is_away ? w.y1 : w.y0});
		const Pixel start = *interact::pixelOf(scene.view, taken);
		const Pixel end = *interact::pixelOf(scene.view, taken + 3.0 * away);
		const Drag drag({kind, 1, 0, up_is_away ? 2 : 1}, start, scene.view, scene.probe, scene.bounds);
		double last = 0.0;
		for (double way = 0.1; way < 40.0; way += 0.1)
		{
			const probe::Probe probe = drag.to(start + way * (end - start));
			const double now = kind == HandleKind::move ? glm::dot(probe.frame.origin - frame.origin, away)
			                                            : probe.sheets[0].window->height() - w.height();
			EXPECT_GE(now, last) << way;
			last = now;
		}
		EXPECT_NEAR(last, 10.0 * scene.bounds.diagonal(), 1e-6);
	}
}

TEST(Drag, HorizonsAreNotJumpedOver)
{
	expectNoJumpBeyondHorizons(sceneNamed("7 from 33,-8"));
	expectNoJumpBeyondHorizons(sceneNamed("7 from iso"));
}

TEST(Drag, WindowsKeepALeastSize)
{
	Scene scene = sceneNamed("1 from sheet");
	const probe::Sheet sheet = probe::placed(scene.probe).sheets[0];
	const probe::Window w = *sheet.window;
	const Drag drag({HandleKind::corner, 0, 0, 2},
	                *interact::pixelOf(scene.view, interact::pointOn(sheet, {w.x1, w.y1})), scene.view, scene.probe,
	                scene.bounds);
	const Pixel beyond = *interact::pixelOf(scene.view, interact::pointOn(sheet, {w.x0 - 1.0, w.y0 - 1.0}));
	const probe::Window least = *drag.to(beyond).sheets[0].window;
	EXPECT_EQ(least.x0, w.x0);
	EXPECT_EQ(least.y0, w.y0);
	EXPECT_NEAR(least.width(), 1e-6 * scene.bounds.diagonal(), 1e-12);
	EXPECT_NEAR(least.height(), 1e-6 * scene.bounds.diagonal(), 1e-12);
}

} // namespace vp::test
