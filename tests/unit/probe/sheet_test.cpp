#include "random_probes.h"

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

TEST(Sheet, FxShowsThePannedPointAtTheOriginMagnified)
{
	const probe::Transform fx = probe::fxTransform({4.0, {1.0, 2.0, 3.0}});
	EXPECT_EQ(fx.point({1.0, 2.0, 3.0}), Vec3(0.0));
	EXPECT_EQ(fx.point({1.5, 2.0, 3.0}), Vec3(2.0, 0.0, 0.0));
	EXPECT_EQ(fx.point({1.0, 2.0, 3.25}), Vec3(0.0, 0.0, 1.0));
	EXPECT_EQ(probe::fxTransform({}), probe::Transform());
}

TEST(Sheet, ToCubeMapsTheWindowToTheUnitSquare)
{
	const probe::Transform cube = probe::toCube({-1.0, 3.0, 2.0, 4.0});
	EXPECT_EQ(cube.point({-1.0, 2.0, 0.0}), Vec3(0.0));
	EXPECT_EQ(cube.point({3.0, 4.0, 0.0}), Vec3(1.0, 1.0, 0.0));
	EXPECT_EQ(cube.point({1.0, 3.0, 7.0}), Vec3(0.5, 0.5, 7.0));
	EXPECT_EQ(probe::centeredWindow(4.0, 2.0), (probe::Window{-2.0, 2.0, -1.0, 1.0}));
}

TEST(Sheet, WithoutFxCutAndDrawingAgree)
{
	std::mt19937 random(11);
	for (int i = 0; i < 100; ++i)
	{
		probe::Sheet sheet = randomSheet(random);
		sheet.fx = {};
		EXPECT_EQ(content(sheet), sheet);
		EXPECT_EQ(displayTransform(sheet), probe::Transform());
		expectNear(worldToSheet(sheet) * sheetToWorld(sheet), probe::Transform(), 1e-13);
	}
}

// Points of the cut go through the paper's product into the window, and through its inverse, which knows no fx, to
// where they are drawn.
TEST(Sheet, TheProductCutsAndTheInverseDraws)
{
	std::mt19937 random(12);
	for (int i = 0; i < 200; ++i)
	{
		const probe::Sheet sheet = randomSheet(random);
		const probe::Sheet cut = content(sheet);
		const double u = between(-1.0, 2.0, random);
		const double v = between(-1.0, 2.0, random);
		const Vec3 p = fromFrame(cut).point({cut.window->x0 + u * cut.window->width(),
		                                     cut.window->y0 + v * cut.window->height(), 0.0}); // in the content's plane
		EXPECT_NEAR(cut.plane().signedDistance(p), 0.0, 1e-13);
		expectNear(worldToSheet(sheet).point(p), {u, v, 0.0}, 1e-11);
		EXPECT_NEAR(worldToWindow(sheet, p).x, u, 1e-11);
		EXPECT_NEAR(worldToWindow(sheet, p).y, v, 1e-11);
		expectNear(displayTransform(sheet), worldToSheet(sheet) * sheetToWorld(sheet), 1e-11);

		// Drawn in the sheet's own plane, in the sheet's own window.
		const Vec3 drawn = displayTransform(sheet).point(p);
		const Vec3 local = toFrame(sheet).point(drawn);
		expectNear(local,
		           {sheet.window->x0 + u * sheet.window->width(), sheet.window->y0 + v * sheet.window->height(), 0.0},
		           1e-12);
		expectNear(inverse(displayTransform(sheet)).point(drawn), p, 1e-12); // the true position under a pointer
	}
}

TEST(Sheet, TheHotSpotOfAMagnifiedSheetIsThePannedPoint)
{
	std::mt19937 random(13);
	for (int i = 0; i < 100; ++i)
	{
		const probe::Sheet sheet = randomSheet(random);
		expectNear(toFrame(sheet).point(contentHotSpot(sheet)), sheet.fx.pan, 1e-13);
		EXPECT_EQ(content(sheet).origin, contentHotSpot(sheet));
		expectNear(displayTransform(sheet).point(contentHotSpot(sheet)), sheet.origin, 1e-13);
	}
}

TEST(Sheet, FarFromZeroTheWindowKeepsItsDigits)
{
	probe::Sheet sheet = probe::makeSheet(Vec3(1e7), {0.3, 0.5, 0.81});
	sheet.window = probe::centeredWindow(1e-3, 1e-3);
	EXPECT_EQ(worldToWindow(sheet, sheet.origin), glm::dvec2(0.5, 0.5));
	const Vec3 p = sheet.origin + 0.0005 * sheet.up;
	EXPECT_NEAR(worldToWindow(sheet, p).y, 1.0, 1e-5); // 1e7 itself is known to 2e-9
}

} // namespace vp::test
