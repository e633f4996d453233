#include "interact/pick.h"

#include "probe/presets.h"

#include "interact/steps.h"
#include "scenes.h"

#include <algorithm>

namespace vp::test
{

using interact::HandleShape;
using interact::SheetHit;

namespace
{

double lengthOnScreen(const View& view, const std::vector<Vec3>& line)
{
	double sum = 0.0;
	for (std::size_t i = 1; i < line.size(); ++i)
		sum += glm::length(view.camera.project(line[i], view.frame) - view.camera.project(line[i - 1], view.frame));
	return sum;
}

int rankOf(HandleKind kind)
{
	return kind == HandleKind::edge ? 2 : kind == HandleKind::turn ? 1 : 0;
}

} // namespace

TEST(Handles, EveryVisibleSheetHasItsOwn)
{
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		const auto shapes = interact::handlesOf(scene.probe, scene.view, scene.bounds);
		const auto count = [&](HandleKind kind, std::size_t sheet)
		{
			return std::ranges::count_if(shapes, [&](const HandleShape& shape)
			                             { return shape.handle.kind == kind && shape.handle.sheet == sheet; });
		};
		EXPECT_EQ(count(HandleKind::move, 0), 3);
		EXPECT_EQ(count(HandleKind::turn, 0), 3);
		EXPECT_EQ(count(HandleKind::center, 0), 1);
		for (std::size_t s = 0; s < scene.probe.sheets.size(); ++s)
		{
			const probe::Sheet& sheet = scene.probe.sheets[s];
			// A window that nobody has sized has no sides to drag.
			const bool is_sized = sheet.window && !probe::reachesAround(*sheet.window, scene.bounds);
			const int windowed = is_sized && !sheet.wishes.hidden ? 4 : 0;
			EXPECT_EQ(count(HandleKind::edge, s), windowed);
			EXPECT_EQ(count(HandleKind::corner, s), windowed);
			EXPECT_EQ(count(HandleKind::sheet, s), sheet.wishes.hidden ? 0 : 1);
		}
		for (const HandleShape& shape : shapes)
		{
			EXPECT_GE(shape.alpha, 0.0);
			EXPECT_LE(shape.alpha, 1.0);
			EXPECT_TRUE(shape.alpha > 0.0 || !shape.pickable);
		}
	}
}

TEST(Handles, HiddenProbesAndThoseBehindTheEyeHaveNone)
{
	Scene scene = allScenes()[3];
	scene.probe.sheets[0].wishes.hidden = true;
	EXPECT_TRUE(interact::handlesOf(scene.probe, scene.view, scene.bounds).empty());
	scene.probe.sheets[0].wishes.hidden = false;
	scene.probe.frame.origin = scene.view.camera.position - scene.view.camera.forward();
	EXPECT_TRUE(interact::handlesOf(scene.probe, scene.view, scene.bounds).empty());
}

TEST(Handles, HaveOneSizeOnScreen)
{
	for (const Scene& scene : allScenes())
		for (const double ui_scale : {1.0, 2.0})
		{
			SCOPED_TRACE(scene.name);
			for (const HandleShape& shape :
			     interact::handlesOf(scene.probe, scene.view, scene.bounds, {ui_scale, std::nullopt}))
			{
				if (shape.handle.kind == HandleKind::center)
				{
					EXPECT_NEAR(lengthOnScreen(scene.view, shape.lines[0]), 44.0 * ui_scale, 2.0 * ui_scale);
				}
				if (shape.handle.kind != HandleKind::move)
					continue;
				const Vec3 along = interact::axisOf(scene.probe.frame, shape.handle.axis);
				const Vec3 sight = glm::normalize(scene.probe.frame.origin - scene.view.camera.position);
				const double sine = glm::length(glm::cross(along, sight));
				const Vec3 tip = shape.lines[0].back();
				const double reach = glm::length(tip - scene.probe.frame.origin);
				const double depth = interact::depthOf(scene.view, scene.probe.frame.origin);
				EXPECT_NEAR(reach * interact::pixelsPerLength(scene.view, depth), ui_scale * interact::kArrowPixels,
				            0.01);
				EXPECT_EQ(shape.pickable, sine > interact::kAtEye);
				EXPECT_EQ(shape.alpha == 1.0, sine >= 2.0 * interact::kAtEye);
			}
		}
}

TEST(Handles, CornersLieWhereTheirSidesMeet)
{
	for (const Scene& scene : allScenes())
	{
		const auto shapes = interact::handlesOf(scene.probe, scene.view, scene.bounds);
		for (const HandleShape& corner : shapes)
			for (const HandleShape& side : shapes)
			{
				const Handle& c = corner.handle;
				const Handle& s = side.handle;
				if (c.kind != HandleKind::corner || s.kind != HandleKind::edge || c.sheet != s.sheet)
					continue;
				const auto& ends = side.lines[0];
				const bool meets = ends[0] == corner.lines[0][1] || ends[1] == corner.lines[0][1];
				EXPECT_EQ(meets, std::ranges::count(interact::cornerSides(c.part), s.part) == 1);
				const probe::Sheet sheet = probe::placed(scene.probe).sheets[s.sheet];
				const Vec3 axis = s.part < 2 ? sheet.xAxis() : sheet.up;
				const probe::Window& w = *sheet.window;
				const double at = std::array{w.x0, w.x1, w.y0, w.y1}[s.part];
				EXPECT_NEAR(glm::dot(ends[0] - sheet.origin, axis), at, 1e-7);
				EXPECT_NEAR(glm::dot(ends[1] - sheet.origin, axis), at, 1e-7);
			}
	}
}

TEST(Handles, SayWhatTheyDo)
{
	EXPECT_EQ(interact::wordsOf({HandleKind::turn, 2}), "Turn about the normal");
	EXPECT_EQ(interact::wordsOf({HandleKind::move, 1}), "Move along up");
	EXPECT_EQ(interact::wordsOf({HandleKind::corner, 0, 0, 2}), "Resize the window");
}

TEST(Handles, StandAtASheetOfItsOwn)
{
	for (const Scene& scene : allScenes())
	{
		const std::size_t last = scene.probe.sheets.size() - 1;
		const Vec3 at = probe::placed(scene.probe).sheets[last].origin;
		for (const HandleShape& shape : interact::handlesOf(scene.probe, scene.view, scene.bounds, {1.0, last}))
			if (rankOf(shape.handle.kind) < 2 && shape.handle.own)
			{
				EXPECT_EQ(shape.handle.sheet, last);
				EXPECT_EQ(interact::standOf(scene.probe, shape.handle).origin, at);
			}
	}
}

TEST(Pick, HandlesAreFoundWhereTheyAreDrawn)
{
	std::mt19937 random(7);
	int found = 0;
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		const auto shapes = interact::handlesOf(scene.probe, scene.view, scene.bounds);
		for (const HandleShape& shape : shapes)
		{
			if (shape.lines.empty())
				continue;
			const auto& line = shape.lines[random() % shape.lines.size()];
			const std::size_t i = 1 + random() % (line.size() - 1);
			const Vec3 at = line[i - 1] + uniform(0.0, 1.0, random) * (line[i] - line[i - 1]);
			const auto pixel = interact::pixelOf(scene.view, at);
			if (!pixel)
				continue;
			const auto alone = interact::pickHandle(std::span(&shape, 1), scene.view, *pixel + Pixel(1.0, -1.0));
			EXPECT_EQ(alone.has_value(), shape.pickable);
			EXPECT_FALSE(interact::pickHandle(std::span(&shape, 1), scene.view, *pixel + Pixel(1e5, 0.0)));
			const auto picked = interact::pickHandle(shapes, scene.view, *pixel);
			if (!shape.pickable)
				continue;
			// Only a handle with precedence may be picked in its place.
			ASSERT_TRUE(picked);
			EXPECT_LE(rankOf(picked->kind), rankOf(shape.handle.kind));
			found += *picked == shape.handle;
		}
	}
	EXPECT_GT(found, 1000);
}

TEST(Pick, ArrowsGoBeforeRingsBeforeEdges)
{
	const Scene scene = allScenes()[3];
	const auto segment = [&](HandleKind kind, double y)
	{
		const auto at = [&](double x) { return interact::rayOf(scene.view, {x, y}).at(20.0); };
		return HandleShape{{kind, 0, 0, 0}, {{at(100.0), at(500.0)}}, 1.0, true};
	};
	std::vector<HandleShape> shapes{segment(HandleKind::edge, 200.0), segment(HandleKind::turn, 203.0),
	                                segment(HandleKind::move, 205.0)};
	const auto kindAt = [&](double y)
	{
		const auto picked = interact::pickHandle(shapes, scene.view, {300.0, y});
		return picked ? std::optional(picked->kind) : std::nullopt;
	};
	EXPECT_EQ(kindAt(200.0), HandleKind::move);
	EXPECT_EQ(kindAt(198.5), HandleKind::turn);
	EXPECT_EQ(kindAt(194.5), HandleKind::edge);
	EXPECT_EQ(kindAt(193.5), std::nullopt);
	// Among handles of one rank, the nearest is picked.
	shapes.push_back(segment(HandleKind::corner, 200.5));
	EXPECT_EQ(kindAt(201.0), HandleKind::corner);
	EXPECT_EQ(kindAt(204.0), HandleKind::move);
}

// Each sheet asked by itself: a point of it is picked at its pixel, in the order of depths.
TEST(Pick, SheetsAreHitWhereTheyAreSeen)
{
	std::mt19937 random(11);
	int hits = 0;
	for (const Scene& scene : allScenes())
	{
		SCOPED_TRACE(scene.name);
		const probe::Probe world = probe::placed(scene.probe);
		for (int i = 0; i < 60; ++i)
		{
			const Pixel pixel = somePixel(scene.view, random);
			const auto found = interact::pickSheets(scene.probe, scene.view, pixel, scene.bounds);
			EXPECT_TRUE(std::ranges::is_sorted(found, {}, &SheetHit::depth));
			for (const SheetHit& hit : found)
			{
				const probe::Sheet& sheet = world.sheets[hit.sheet];
				EXPECT_FALSE(sheet.wishes.hidden);
				EXPECT_NEAR(glm::dot(hit.point - sheet.origin, sheet.normal), 0.0, 1e-7);
				EXPECT_LT(glm::length(*interact::pixelOf(scene.view, hit.point) - pixel), 1e-2);
				// The content is drawn at the place where it was hit.
				const Vec3 shown = probe::displayTransform(sheet).point(hit.content);
				EXPECT_LT(glm::length(shown - hit.point), 1e-7);
				const probe::Sheet content = probe::content(sheet);
				EXPECT_LT(glm::length(interact::pointOn(content, hit.content_uv) - hit.content), 1e-7);
				if (sheet.window)
				{
					const glm::dvec2 in_window = probe::worldToWindow(sheet, hit.content);
					EXPECT_TRUE(glm::all(glm::greaterThan(in_window, glm::dvec2(-0.01))));
					EXPECT_TRUE(glm::all(glm::lessThan(in_window, glm::dvec2(1.01))));
				}
				++hits;
			}
		}
	}
	EXPECT_GT(hits, 1000);
}

TEST(Pick, SheetsOutsideTheirWindowsOrTheBoundsAreNotHit)
{
	const Scene scene = allScenes()[2]; // a sheet without a window, from z
	const auto at = [&](const Vec3& p) { return *interact::pixelOf(scene.view, p); };
	const auto hits = [&](const probe::Probe& probe, const Vec3& p)
	{ return interact::pickSheets(probe, scene.view, at(p), scene.bounds).size(); };
	EXPECT_EQ(hits(scene.probe, {0.9, 1.9, 0.0}), 1u);
	EXPECT_EQ(hits(scene.probe, {1.1, 1.9, 0.0}), 0u);
	probe::Probe windowed = scene.probe;
	windowed.sheets[0].window = probe::Window{0.0, 3.0, -0.5, 0.5};
	EXPECT_EQ(hits(windowed, {2.9, 0.4, 0.0}), 1u);
	EXPECT_EQ(hits(windowed, {-0.1, 0.4, 0.0}), 0u);
	// Magnified, the bounds reach farther.
	probe::Probe magnified = scene.probe;
	magnified.sheets[0].fx.magnification = 2.0;
	EXPECT_EQ(hits(magnified, {1.9, 0.0, 0.0}), 1u);
	EXPECT_EQ(hits(magnified, {2.1, 0.0, 0.0}), 0u);
	magnified.sheets[0].wishes.hidden = true;
	EXPECT_EQ(hits(magnified, {1.9, 0.0, 0.0}), 0u);
}

TEST(Steps, AreRound)
{
	std::mt19937 random(2);
	for (int i = 0; i < 1000; ++i)
	{
		const double size = std::pow(10.0, uniform(-8.0, 8.0, random));
		const double step = interact::roundStep({Vec3(0.0), Vec3(size, 0.0, 0.0)});
		EXPECT_LT(std::max(step * 50.0 / size, size / (step * 50.0)), 1.6);
		const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
		EXPECT_TRUE(std::abs(digit - 1.0) < 1e-9 || std::abs(digit - 2.0) < 1e-9 || std::abs(digit - 5.0) < 1e-9)
		    << step;
	}
	EXPECT_EQ(interact::roundStep({Vec3(0.0), Vec3(6.0, 0.0, 0.0)}), 0.1);
	EXPECT_EQ(interact::roundStep({}), 0.02);
}

} // namespace vp::test
