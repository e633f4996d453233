#include "interact/nudge.h"

#include "interact/history.h"
#include "interact/pick.h"
#include "interact/steps.h"
#include "scenes.h"

namespace vp::test
{

using interact::Part;

TEST(Nudge, PushesGoAlongTheSheetsNormalInRoundSteps)
{
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		const double step = interact::roundStep(scene.bounds);
		for (std::size_t s = 0; s < scene.probe.sheets.size(); ++s)
		{
			const probe::Sheet sheet = probe::placed(scene.probe).sheets[s];
			const auto way = [&](const probe::Probe& pushed)
			{ return probe::placed(pushed).sheets[s].origin - sheet.origin; };
			const probe::Probe all = interact::pushed(scene.probe, s, 3.0, scene.bounds);
			const probe::Probe back = interact::pushed(scene.probe, s, -2.0, scene.bounds, true);
			const probe::Probe own = interact::pushed(scene.probe, s, 3.0, scene.bounds, false, true);
			EXPECT_LT(glm::length(way(all) - 3.0 * step * sheet.normal), 1e-7);
			EXPECT_LT(glm::length(way(back) + 0.2 * step * sheet.normal), 1e-7);
			EXPECT_LT(glm::length(way(own) - 3.0 * step * sheet.normal), 1e-7);
			EXPECT_TRUE(all.sheets == scene.probe.sheets);
			EXPECT_EQ(own.frame, scene.probe.frame);
			for (std::size_t other = 0; other < own.sheets.size(); ++other)
				EXPECT_EQ(own.sheets[other] == scene.probe.sheets[other], other != s);
		}
	}
}

TEST(Nudge, WindowsGrowAboutAPlaceThatStays)
{
	std::mt19937 random(1);
	for (int i = 0; i < 500; ++i)
	{
		const double x0 = uniform(-2.0, 2.0, random);
		const double y0 = uniform(-2.0, 2.0, random);
		const probe::Window w{x0, x0 + uniform(1e-3, 3.0, random), y0, y0 + uniform(1e-3, 3.0, random)};
		const glm::dvec2 about(uniform(-3.0, 3.0, random), uniform(-3.0, 3.0, random));
		const double factor = std::pow(10.0, uniform(-9.0, 9.0, random));
		const probe::Window s = interact::scaled(w, factor, about, 1.0);
		const double grown = s.width() / w.width();
		EXPECT_NEAR(s.height() / w.height(), grown, 1e-6 * grown); // in its proportions
		EXPECT_NEAR(s.x0 - about.x, grown * (w.x0 - about.x), 1e-9 * (1.0 + grown));
		EXPECT_NEAR(s.y1 - about.y, grown * (w.y1 - about.y), 1e-9 * (1.0 + grown));
		EXPECT_GE(std::min(s.width(), s.height()), 0.999 * interact::kSmallestWindow);
		EXPECT_LE(std::max(s.width(), s.height()), 1.001 * interact::kLargestWindow);
		const bool bounded = factor * std::min(w.width(), w.height()) < interact::kSmallestWindow ||
		                     factor * std::max(w.width(), w.height()) > interact::kLargestWindow;
		if (!bounded)
		{
			EXPECT_NEAR(grown, factor, 1e-6 * factor);
		}
	}
}

TEST(Nudge, EqualWindowsGrowTogether)
{
	const Box bounds{Vec3(-1.0), Vec3(1.0)};
	probe::Probe wheel = probe::paddlewheel({}, bounds, 3, probe::WindowSize{1.0, 2.0});
	const probe::Probe all = interact::withWindowScaled(wheel, 1, 2.0, bounds);
	for (const probe::Sheet& sheet : all.sheets)
		EXPECT_EQ(*sheet.window, (probe::Window{-0.5, 1.5, -2.0, 2.0}));
	const probe::Probe own = interact::withWindowScaled(wheel, 1, 2.0, bounds, true);
	EXPECT_EQ(own.sheets[0].window, wheel.sheets[0].window);
	EXPECT_EQ(own.sheets[1].window, all.sheets[1].window);
	wheel.sheets[2].window = probe::Window{0.0, 3.0, 0.0, 1.0};
	EXPECT_EQ(interact::withWindowScaled(wheel, 1, 2.0, bounds).sheets[2].window, wheel.sheets[2].window);
	wheel.sheets[0].window.reset();
	EXPECT_TRUE(interact::withWindowScaled(wheel, 0, 2.0, bounds) == wheel);
}

// The magnifier does not change what is shown under the pointer, by the same pick as the viewer's.
TEST(Nudge, TheMagnifierKeepsWhatIsUnderThePointer)
{
	std::mt19937 random(2);
	int done = 0;
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		probe::Probe probe = scene.probe;
		for (int i = 0; i < 30; ++i)
		{
			const Pixel pixel = somePixel(scene.view, random);
			const auto contentAt = [&](const probe::Probe& p, const Pixel& at)
			{ return interact::hitOf(probe::placed(p).sheets[0], 0, scene.view, at); };
			const auto hit = contentAt(probe, pixel);
			const auto other = contentAt(probe, pixel + Pixel(20.0, 7.0));
			if (!hit || !other || glm::length(hit->uv) > 10.0 || glm::length(other->uv) > 10.0)
				continue;
			const double before = probe.sheets[0].fx.magnification;
			const probe::Probe zoomed = interact::magnified(probe, 0, uniform(0.5, 2.5, random), hit->uv);
			EXPECT_LT(glm::length(contentAt(zoomed, pixel)->content - hit->content), 1e-7 * (1.0 + 1.0 / before));
			const probe::Probe panned = interact::magnifierPanned(zoomed, 0, hit->uv, other->uv);
			EXPECT_LT(glm::length(contentAt(panned, pixel + Pixel(20.0, 7.0))->content - hit->content),
			          1e-7 * (1.0 + 1.0 / before));
			probe = zoomed;
			++done;
		}
		EXPECT_EQ(interact::withoutMagnifier(probe, 0).sheets[0].fx, probe::Fx{});
	}
	EXPECT_GT(done, 500);
}

TEST(Nudge, TheMagnificationIsBounded)
{
	probe::Probe probe = probe::single({});
	for (int i = 0; i < 100; ++i)
		probe = interact::magnified(probe, 0, 2.0, {0.3, 0.4});
	EXPECT_EQ(probe.sheets[0].fx.magnification, interact::kMaxMagnification);
	for (int i = 0; i < 100; ++i)
		probe = interact::magnified(probe, 0, 0.5, {0.3, 0.4});
	EXPECT_EQ(probe.sheets[0].fx.magnification, interact::kMinMagnification);
}

TEST(Placing, NormalsTurnAsLittleAsCanBe)
{
	std::mt19937 random(3);
	for (int i = 0; i < 1000; ++i)
	{
		const auto direction = [&]
		{ return Vec3(uniform(-1, 1, random), uniform(-1, 1, random), uniform(-1, 1, random)); };
		const probe::Frame frame = probe::makeFrame(direction(), direction(), direction());
		const Vec3 to = direction();
		const probe::Frame turned = interact::normalTo(frame, to);
		expectFrame(turned);
		EXPECT_EQ(turned.origin, frame.origin);
		EXPECT_LT(glm::length(turned.normal - glm::normalize(to)), 1e-14);
		// A vector that is perpendicular to both normals is not turned.
		const Vec3 axis = glm::normalize(glm::cross(frame.normal, to));
		EXPECT_NEAR(glm::dot(axis, frame.up), glm::dot(axis, turned.up), 1e-9);
		EXPECT_NEAR(glm::dot(axis, frame.xAxis()), glm::dot(axis, turned.xAxis()), 1e-9);
		// From the least difference to the greatest.
		const double off = std::pow(10.0, uniform(-20.0, 0.0, random));
		for (const double side : {1.0, -1.0})
		{
			const probe::Frame near = interact::normalTo(frame, side * (frame.normal + off * frame.up));
			expectFrame(near);
			EXPECT_GT(side * glm::dot(near.normal, frame.normal), 0.7);
			EXPECT_NEAR(std::abs(glm::dot(near.xAxis(), frame.xAxis())), 1.0, 1e-6);
		}
	}
}

TEST(Placing, SnappedNormalsAreTheWorldsAxes)
{
	std::mt19937 random(4);
	for (int i = 0; i < 1000; ++i)
	{
		const Vec3 normal(uniform(-1, 1, random), uniform(-1, 1, random), uniform(-1, 1, random));
		const probe::Frame frame = probe::makeFrame(Vec3(1.0, 2.0, 3.0), normal, {0.3, 0.2, 1.0});
		const probe::Frame snapped = interact::snapNormal(frame);
		expectFrame(snapped);
		const Vec3 size = glm::abs(snapped.normal);
		EXPECT_EQ(size.x + size.y + size.z, 1.0);
		EXPECT_EQ(glm::dot(size, size), 1.0);
		EXPECT_GT(glm::dot(snapped.normal, frame.normal), 0.577);
		const double off = degreesBetween(snapped.normal, frame.normal);
		EXPECT_EQ(interact::snapNormal(frame, off + 1e-6), snapped);
		EXPECT_EQ(interact::snapNormal(frame, off - 1e-6), frame);
	}
}

TEST(Placing, PartsArePlacedInTheWorld)
{
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		const Part last = scene.probe.sheets.size() - 1;
		for (const Part& part : {Part(), last})
		{
			const probe::Frame to =
			    probe::makeFrame(scene.bounds.center() + Vec3(0.1), {1.0, 2.0, -0.5}, {0.0, 0.3, 1.0});
			const probe::Probe placed = interact::withFrame(scene.probe, part, to);
			const probe::Frame at = interact::frameOf(placed, part);
			EXPECT_LT(glm::length(at.origin - to.origin), 1e-7);
			EXPECT_LT(glm::length(at.normal - to.normal), 1e-14);
			EXPECT_LT(glm::length(at.up - to.up), 1e-14);
			const probe::Probe turned = interact::turned(placed, part, {0.2, 0.4, 0.9}, 50.0);
			EXPECT_LT(glm::length(interact::frameOf(turned, part).origin - to.origin), 1e-7);
			const double degrees = 2.0 * degreesBetween(to.normal, glm::normalize(Vec3(0.2, 0.4, 0.9)));
			EXPECT_LE(degreesBetween(interact::frameOf(turned, part).normal, to.normal),
			          std::min(50.0, degrees) + 1e-9);
			for (int axis = 0; axis < 3; ++axis)
			{
				const probe::Frame about = interact::frameOf(interact::turnedAbout(placed, part, axis, 30.0), part);
				EXPECT_LT(glm::length(interact::axisOf(about, axis) - interact::axisOf(at, axis)), 1e-12);
				const int next = (axis + 1) % 3;
				EXPECT_NEAR(degreesBetween(interact::axisOf(about, next), interact::axisOf(at, next)), 30.0, 1e-6);
			}
			const probe::Probe faced = interact::withNormalToCamera(scene.probe, part, scene.view.camera);
			EXPECT_NEAR(glm::dot(interact::frameOf(faced, part).normal, scene.view.camera.forward()), -1.0, 1e-13);
			EXPECT_TRUE(interact::turned(scene.probe, part, {0.0, 0.0, 1.0}, 0.0) == scene.probe);
		}
		const probe::Probe reset = interact::resetPlace(scene.probe, scene.bounds);
		EXPECT_EQ(reset.frame, (probe::Frame{scene.bounds.center(), {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}}));
		EXPECT_TRUE(reset.sheets == scene.probe.sheets);
	}
}

// Whatever was done, undoing all of it gives the first state back to the last bit.
TEST(Nudge, UndoingEverythingGivesTheFirstProbe)
{
	std::mt19937 random(5);
	const std::vector<Scene> scenes = allScenes();
	for (std::size_t i = 0; i < scenes.size(); i += 7)
	{
		const Scene& scene = scenes[i];
		interact::History<probe::Probe> history(scene.probe);
		std::vector<probe::Probe> states{scene.probe};
		for (int step = 0; step < 100; ++step)
		{
			const probe::Probe& now = history.state();
			const std::size_t s = random() % now.sheets.size();
			const Vec3 axis(uniform(0.1, 1, random), uniform(-1, 1, random), uniform(-1, 1, random));
			const std::array next{interact::pushed(now, s, 1.0, scene.bounds, true, true),
			                      interact::turned(now, s, axis, uniform(-9.0, 9.0, random)),
			                      interact::withWindowScaled(now, s, 1.1, scene.bounds),
			                      interact::magnified(now, s, 1.2, {0.1, 0.2}), interact::withNormal(now, {}, axis)};
			if (history.commit(next[random() % next.size()], "step"))
				states.push_back(history.state());
		}
		EXPECT_GT(states.size(), 50u);
		for (std::size_t k = states.size() - 1; k-- > 0;)
		{
			ASSERT_TRUE(history.undo());
			ASSERT_TRUE(history.state() == states[k]);
		}
		EXPECT_FALSE(history.canUndo());
		while (history.redo())
			;
		EXPECT_TRUE(history.state() == states.back());
	}
}

} // namespace vp::test
