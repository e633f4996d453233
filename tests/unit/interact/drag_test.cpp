#include "interact/drag.h"

#include "interact/pick.h"
#include "interact/steps.h"
#include "scenes.h"

#include <algorithm>
#include <functional>

namespace vp::test
{

using interact::Drag;
using interact::HandleShape;
using interact::Modifiers;

namespace
{

std::vector<Modifiers> allModifiers()
{
	std::vector<Modifiers> all;
	for (int i = 0; i < 16; ++i)
		all.push_back({(i & 1) != 0, (i & 2) != 0, (i & 4) != 0, (i & 8) != 0});
	return all;
}

std::vector<Handle> handlesIn(const Scene& scene, HandleKind kind)
{
	std::vector<Handle> handles;
	for (const HandleShape& shape : interact::handlesOf(scene.probe, scene.view, scene.bounds))
		if (shape.handle.kind == kind)
			handles.push_back(shape.handle);
	return handles;
}

double sineToSight(const Scene& scene, const Vec3& through, const Vec3& axis)
{
	return glm::length(glm::cross(axis, glm::normalize(through - scene.view.camera.position)));
}

double toPlane(const Scene& scene, const Vec3& through, const Vec3& normal)
{
	return std::abs(glm::dot(normal, glm::normalize(through - scene.view.camera.position)));
}

// Drags from where a point is seen to where another one is, and expects the first there.
void expectFollows(const Scene& scene, const Handle& handle, const Vec3& from, const Vec3& to,
                   const std::function<Vec3(const probe::Probe&)>& followed, int& done)
{
	const auto start = interact::pixelOf(scene.view, from);
	const auto end = interact::pixelOf(scene.view, to);
	if (!start || !end)
		return;
	const Drag drag(handle, *start, scene.view, scene.probe, scene.bounds);
	const auto seen = interact::pixelOf(scene.view, followed(drag.to(*end)));
	ASSERT_TRUE(seen);
	EXPECT_LT(glm::length(*seen - *end), 1.0);
	++done;
}

void expectSound(const probe::Probe& probe)
{
	expectFrame(probe.frame);
	for (const probe::Sheet& sheet : probe.sheets)
	{
		expectFrame(sheet);
		if (sheet.window)
		{
			EXPECT_LT(sheet.window->x0, sheet.window->x1);
			EXPECT_LT(sheet.window->y0, sheet.window->y1);
			EXPECT_LT(std::max(sheet.window->width(), sheet.window->height()), 1e3);
		}
	}
}

} // namespace

// Wherever the pointer has been meanwhile, and off the picture too.
TEST(Drag, TheFirstPixelGivesTheFirstProbeBack)
{
	std::mt19937 random(1);
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		for (const HandleShape& shape : interact::handlesOf(scene.probe, scene.view, scene.bounds))
		{
			const Pixel start = somePixel(scene.view, random);
			const Drag drag(shape.handle, start, scene.view, scene.probe, scene.bounds);
			for (const Modifiers& modifiers : allModifiers())
			{
				const double reach = std::pow(10.0, uniform(-2.0, 6.0, random));
				const Pixel away(uniform(-reach, reach, random), uniform(-reach, reach, random));
				const probe::Probe there = drag.to(start + away, modifiers);
				expectSound(there);
				EXPECT_TRUE(drag.to(start + away, modifiers) == there);
				EXPECT_TRUE(drag.to(start, modifiers) == scene.probe);
			}
		}
	}
}

TEST(Drag, ArrowsFollowThePointer)
{
	std::mt19937 random(2);
	int done = 0;
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		for (const Handle& handle : handlesIn(scene, HandleKind::move))
		{
			const Vec3 axis = interact::axisOf(scene.probe.frame, handle.axis);
			const Vec3 origin = scene.probe.frame.origin;
			if (sineToSight(scene, origin, axis) < interact::kAtEye)
				continue;
			const Vec3 taken = origin + uniform(0.05, 0.4, random) * axis;
			const Vec3 end = taken + uniform(-1.5, 1.5, random) * axis;
			expectFollows(
			    scene, handle, taken, end,
			    [&](const probe::Probe& moved) { return taken + (moved.frame.origin - origin); }, done);
		}
	}
	EXPECT_GT(done, 250);
}

TEST(Drag, SheetsFollowThePointerAlongTheirNormals)
{
	std::mt19937 random(3);
	int done = 0;
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		for (int i = 0; i < 20; ++i)
			for (const auto& hit :
			     interact::pickSheets(scene.probe, scene.view, somePixel(scene.view, random), scene.bounds))
			{
				const Vec3 normal = probe::placed(scene.probe).sheets[hit.sheet].normal;
				if (sineToSight(scene, hit.point, normal) < interact::kAtEye)
					continue;
				expectFollows(
				    scene, {HandleKind::sheet, 2, hit.sheet}, hit.point,
				    hit.point + uniform(-1.0, 1.0, random) * normal,
				    [&](const probe::Probe& moved)
				    { return hit.point + (moved.frame.origin - scene.probe.frame.origin); },
				    done);
			}
	}
	EXPECT_GT(done, 200);
}

TEST(Drag, TheCenterFollowsThePointerAnywhere)
{
	std::mt19937 random(4);
	int done = 0;
	for (const Scene& scene : allScenes())
		for (const Handle& handle : handlesIn(scene, HandleKind::center))
		{
			SCOPED_TRACE(scene.name);
			const Vec3 origin = scene.probe.frame.origin;
			const Vec3 end =
			    interact::rayOf(scene.view, somePixel(scene.view, random)).at(interact::depthOf(scene.view, origin));
			expectFollows(
			    scene, handle, origin, end, [](const probe::Probe& moved) { return moved.frame.origin; }, done);
		}
	EXPECT_GT(done, 100);
}

TEST(Drag, RingsFollowThePointer)
{
	std::mt19937 random(5);
	int done = 0;
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		for (const Handle& handle : handlesIn(scene, HandleKind::turn))
		{
			const probe::Frame& frame = scene.probe.frame;
			const Vec3 axis = interact::axisOf(frame, handle.axis);
			if (toPlane(scene, frame.origin, axis) < interact::kEdgeOn)
				continue;
			const Vec3 x = interact::axisOf(frame, (handle.axis + 1) % 3);
			const Vec3 y = interact::axisOf(frame, (handle.axis + 2) % 3);
			const auto onRing = [&](double angle)
			{ return frame.origin + 0.3 * (std::cos(angle) * x + std::sin(angle) * y); };
			const double from = uniform(0.0, 7.0, random);
			// The point taken, as one of the probe's.
			const Vec3 inner = probe::toFrame({Vec3(0.0), frame.normal, frame.up}).vector(onRing(from) - frame.origin);
			expectFollows(
			    scene, handle, onRing(from), onRing(uniform(0.0, 7.0, random)),
			    [&](const probe::Probe& turned)
			    {
				    EXPECT_EQ(turned.frame.origin, frame.origin);
				    return probe::fromFrame(turned.frame).point(inner);
			    },
			    done);
		}
	}
	EXPECT_GT(done, 250);
}

TEST(Drag, EdgesAndCornersFollowThePointerAndTheOppositeSideStays)
{
	std::mt19937 random(6);
	int done = 0;
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		for (const HandleKind kind : {HandleKind::edge, HandleKind::corner})
			for (const Handle& handle : handlesIn(scene, kind))
			{
				const probe::Sheet sheet = probe::placed(scene.probe).sheets[handle.sheet];
				const probe::Window w = *sheet.window;
				const bool corner = kind == HandleKind::corner;
				const std::array<int, 2> sides =
				    corner ? interact::cornerSides(handle.part) : std::array{handle.part, handle.part};
				glm::dvec2 at(uniform(w.x0, w.x1, random), uniform(w.y0, w.y1, random));
				glm::dvec2 way(0.0);
				for (const int side : sides)
				{
					at[side / 2] = std::array{w.x0, w.x1, w.y0, w.y1}[side];
					way[side / 2] = uniform(-0.4, 0.9, random) * (side / 2 == 0 ? w.width() : w.height()) *
					                (side % 2 == 0 ? -1.0 : 1.0);
				}
				const Vec3 taken = interact::pointOn(sheet, at);
				const Vec3 axis = handle.part < 2 ? sheet.xAxis() : sheet.up;
				if (corner ? toPlane(scene, taken, sheet.normal) < interact::kEdgeOn
				           : sineToSight(scene, taken, axis) < interact::kAtEye)
					continue;
				expectFollows(
				    scene, handle, taken, interact::pointOn(sheet, at + way),
				    [&](const probe::Probe& resized)
				    {
					    const probe::Window& now = *resized.sheets[handle.sheet].window;
					    const std::array before{w.x0, w.x1, w.y0, w.y1};
					    const std::array after{now.x0, now.x1, now.y0, now.y1};
					    glm::dvec2 moved = at;
					    for (int side = 0; side < 4; ++side)
						    if (side == sides[0] || side == sides[1])
							    moved[side / 2] = after[side];
						    else
							    EXPECT_EQ(after[side], before[side]);
					    return interact::pointOn(sheet, moved);
				    },
				    done);
			}
	}
	EXPECT_GT(done, 1000);
}

} // namespace vp::test
