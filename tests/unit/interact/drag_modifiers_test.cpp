#include "interact/drag.h"

#include "interact/steps.h"
#include "scenes.h"

#include <algorithm>

namespace vp::test
{

using interact::Drag;
using interact::Modifiers;

namespace
{

constexpr Modifiers kFine{true, false, false, false};
constexpr Modifiers kSnap{false, true, false, false};
constexpr Modifiers kBothSides{false, false, true, false};
constexpr Modifiers kOwn{false, false, false, true};

// Returns all handles that may be in a scene, visible or not.
std::vector<Handle> everyHandle(const Scene& scene)
{
	std::vector<Handle> handles;
	for (const auto& shape : interact::handlesOf(scene.probe, scene.view, scene.bounds))
		handles.push_back(shape.handle);
	return handles;
}

bool isMultiple(double value, double step, double tolerance)
{
	return std::abs(value - interact::rounded(value, step)) < tolerance;
}

} // namespace

TEST(DragModifiers, FineGoesATenthOfTheWay)
{
	std::mt19937 random(1);
	for (const Scene& scene : allScenes())
		for (const Handle& handle : everyHandle(scene))
		{
			SCOPED_TRACE(scene.name);
			const Pixel start = startOf(scene);
			const Pixel end = start + Pixel(uniform(-30.0, 30.0, random), uniform(-30.0, 30.0, random));
			const Drag drag(handle, start, scene.view, scene.probe, scene.bounds);
			const probe::Probe whole = drag.to(end);
			const probe::Probe fine = drag.to(end, kFine);
			const Vec3 way = whole.frame.origin - scene.probe.frame.origin;
			EXPECT_LT(glm::length(fine.frame.origin - scene.probe.frame.origin - 0.1 * way), 1e-8);
			if (handle.kind == HandleKind::turn)
			{
				const auto turned = [&](const probe::Probe& p)
				{
					const int beside = (handle.axis + 1) % 3;
					return degreesBetween(interact::axisOf(p.frame, beside),
					                      interact::axisOf(scene.probe.frame, beside));
				};
				EXPECT_NEAR(turned(fine), 0.1 * turned(whole), 1e-6);
			}
		}
}

TEST(DragModifiers, SnapGoesInRoundSteps)
{
	std::mt19937 random(2);
	for (const Scene& scene : allScenes())
		for (const Handle& handle : everyHandle(scene))
		{
			SCOPED_TRACE(scene.name);
			const Pixel start = startOf(scene);
			const Pixel end = start + Pixel(uniform(-300.0, 300.0, random), uniform(-300.0, 300.0, random));
			const double step = interact::roundStep(scene.bounds);
			const Drag drag(handle, start, scene.view, scene.probe, scene.bounds);
			const probe::Probe snapped = drag.to(end, kSnap);
			const Vec3 way = snapped.frame.origin - scene.probe.frame.origin;
			if (handle.kind == HandleKind::move || handle.kind == HandleKind::sheet)
			{
				EXPECT_TRUE(isMultiple(glm::length(way), step, 1e-7)) << glm::length(way);
				EXPECT_LE(glm::length(way - (drag.to(end).frame.origin - scene.probe.frame.origin)), 0.5 * step + 1e-7);
			}
			if (handle.kind == HandleKind::center)
			{
				EXPECT_TRUE(isMultiple(glm::dot(way, scene.view.camera.right()), step, 1e-7));
				EXPECT_TRUE(isMultiple(glm::dot(way, scene.view.camera.trueUp()), step, 1e-7));
			}
			if (handle.kind == HandleKind::turn && handle.axis == 2)
			{
				EXPECT_TRUE(isMultiple(degreesBetween(snapped.frame.up, scene.probe.frame.up), 15.0, 1e-5));
				EXPECT_LT(degreesBetween(snapped.frame.up, drag.to(end).frame.up), 7.51);
			}
		}
}

TEST(DragModifiers, ANormalNearAWorldAxisBecomesIt)
{
	int onto = 0;
	int beside = 0;
	for (const Scene& scene : allScenes())
		for (const int axis : {0, 1})
			for (double x = -400.0; x <= 400.0; x += 10.0)
			{
				const Drag drag({HandleKind::turn, axis}, startOf(scene), scene.view, scene.probe, scene.bounds);
				const Pixel end = startOf(scene) + Pixel(x, 0.37 * x);
				if (x == 0.0)
					continue;
				const Vec3 free = drag.to(end).frame.normal;
				const Vec3 snapped = drag.to(end, kSnap).frame.normal;
				const double largest = std::max({std::abs(free.x), std::abs(free.y), std::abs(free.z)});
				const double off = std::acos(std::min(1.0, largest)) * 180.0 / std::numbers::pi;
				const Vec3 size = glm::abs(snapped);
				const bool exact =
				    size == Vec3(1.0, 0.0, 0.0) || size == Vec3(0.0, 1.0, 0.0) || size == Vec3(0.0, 0.0, 1.0);
				if (off < 3.99)
				{
					EXPECT_TRUE(exact) << off;
					EXPECT_GT(glm::dot(snapped, free), 0.99);
					++onto;
				}
				else if (off > 4.01)
				{
					const double turned = degreesBetween(snapped, scene.probe.frame.normal);
					EXPECT_TRUE(isMultiple(turned, 15.0, 1e-5)) << turned;
					++beside;
				}
			}
	EXPECT_GT(onto, 100);
	EXPECT_GT(beside, 1000);
}

TEST(DragModifiers, BothSidesKeepTheMiddle)
{
	std::mt19937 random(3);
	int windows = 0;
	for (const Scene& scene : allScenes())
		for (const Handle& handle : everyHandle(scene))
		{
			if (handle.kind != HandleKind::edge && handle.kind != HandleKind::corner)
				continue;
			SCOPED_TRACE(scene.name);
			const probe::Window first = *scene.probe.sheets[handle.sheet].window;
			const Drag drag(handle, startOf(scene), scene.view, scene.probe, scene.bounds);
			const Pixel end = startOf(scene) + Pixel(uniform(-9.0, 9.0, random), uniform(-9.0, 9.0, random));
			const probe::Window one = *drag.to(end).sheets[handle.sheet].window;
			const probe::Window both = *drag.to(end, kBothSides).sheets[handle.sheet].window;
			const double size = first.width() + first.height();
			EXPECT_NEAR(both.x0 + both.x1, first.x0 + first.x1, 1e-12 * (size + both.width()));
			EXPECT_NEAR(both.y0 + both.y1, first.y0 + first.y1, 1e-12 * (size + both.height()));
			// Twice the change, but where the least size holds.
			const double grown = one.width() - first.width();
			if (std::abs(grown) < 0.4 * first.width())
			{
				EXPECT_NEAR(both.width() - first.width(), 2.0 * grown, 1e-9 * size);
			}
			++windows;
		}
	EXPECT_GT(windows, 500);
}

// As one: equal windows change together. Alone: one sheet, and neither the frame nor any other.
TEST(DragModifiers, OwnMovesOneSheet)
{
	std::mt19937 random(4);
	for (const Scene& scene : allScenes())
		for (Handle handle : everyHandle(scene))
		{
			SCOPED_TRACE(scene.name);
			if (handle.kind == HandleKind::move || handle.kind == HandleKind::turn || handle.kind == HandleKind::center)
				handle.sheet = random() % scene.probe.sheets.size();
			const Drag drag(handle, startOf(scene), scene.view, scene.probe, scene.bounds);
			const Pixel end = startOf(scene) + Pixel(41.0, 58.0);
			const probe::Probe own = drag.to(end, kOwn);
			EXPECT_EQ(own.frame, scene.probe.frame);
			for (std::size_t s = 0; s < own.sheets.size(); ++s)
				EXPECT_EQ(own.sheets[s] == scene.probe.sheets[s], s != handle.sheet);
			const probe::Probe all = drag.to(end);
			const bool resizes = handle.kind == HandleKind::edge || handle.kind == HandleKind::corner;
			EXPECT_EQ(all.frame == scene.probe.frame, resizes);
			for (std::size_t s = 0; s < all.sheets.size(); ++s)
				EXPECT_EQ(all.sheets[s] == scene.probe.sheets[s], !resizes);
			// Moved by itself it goes the same way in the world.
			if (handle.kind == HandleKind::sheet || handle.kind == HandleKind::move)
			{
				const Vec3 to_own = probe::placed(own).sheets[handle.sheet].origin;
				const Vec3 to_all = probe::placed(all).sheets[handle.sheet].origin;
				EXPECT_LT(glm::length(to_own - to_all), 1e-7);
			}
		}
}

} // namespace vp::test
