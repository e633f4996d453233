#include "render/scene/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace vp::render
{

namespace
{

std::vector<Vec3> boxCorners(const Vec3& lo, const Vec3& hi)
{
	std::vector<Vec3> corners;
	for (int i = 0; i < 8; ++i)
		corners.push_back({i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z});
	return corners;
}

Frame frameWithLegend()
{
	Frame frame{1280.0, 720.0, {20.0, 60.0}, {1100.0, 690.0}, {}};
	return frame;
}

struct Extent
{
	glm::dvec2 lo{std::numeric_limits<double>::infinity()};
	glm::dvec2 hi{-std::numeric_limits<double>::infinity()};
};

Extent pictureOf(const Camera& camera, const std::vector<Vec3>& points, const Frame& frame)
{
	Extent extent;
	for (const Vec3& p : points)
	{
		extent.lo = glm::min(extent.lo, camera.project(p, frame));
		extent.hi = glm::max(extent.hi, camera.project(p, frame));
	}
	return extent;
}

CameraChoice choice(std::string_view text)
{
	auto parsed = parseCamera(text);
	EXPECT_TRUE(parsed) << text;
	return *parsed;
}

} // namespace

TEST(Camera, FillsTheFreeArea)
{
	const Frame frame = frameWithLegend();
	const auto boxes = {boxCorners({-1.0, -2.0, -3.0}, {1.0, 2.0, 3.0}),
	                    boxCorners({1e7, 0.0, 5.0}, {1e7 + 1e-3, 2e-3, 5.001}),
	                    boxCorners({0.0, 0.0, 0.0}, {100.0, 1.0, 0.1})};
	for (const char* text : {"auto", "x", "-x", "y", "-y", "z", "-z", "iso", "sheet", "30,20", "-100,89"})
		for (const auto& points : boxes)
		{
			const probe::Sheet sheet = probe::makeSheet(points[0], {0.3, 0.5, 0.81});
			const Camera camera = makeCamera(choice(text), &sheet, points, frame);
			const Extent extent = pictureOf(camera, points, frame);
			EXPECT_GE(extent.lo.x, frame.free_lo.x - 1e-3) << text;
			EXPECT_GE(extent.lo.y, frame.free_lo.y - 1e-3) << text;
			EXPECT_LE(extent.hi.x, frame.free_hi.x + 1e-3) << text;
			EXPECT_LE(extent.hi.y, frame.free_hi.y + 1e-3) << text;
			const glm::dvec2 filled = (extent.hi - extent.lo) / (frame.free_hi - frame.free_lo);
			EXPECT_GE(std::max(filled.x, filled.y), 0.98) << text;
			// In the middle of what it does not fill.
			EXPECT_NEAR(extent.lo.x - frame.free_lo.x, frame.free_hi.x - extent.hi.x, 25.0) << text;
			EXPECT_NEAR(extent.lo.y - frame.free_lo.y, frame.free_hi.y - extent.hi.y, 25.0) << text;
			for (const Vec3& p : points)
				EXPECT_GE(glm::dot(p - camera.position, camera.forward()), camera.near);
		}
}

TEST(Camera, ParallelProjection)
{
	const Frame frame = frameWithLegend();
	const auto points = boxCorners({-1.0, -2.0, -3.0}, {1.0, 2.0, 3.0});
	for (const char* text : {"x", "-y", "z", "auto", "iso", "30,20"})
	{
		const Camera camera = makeCamera(projected(choice(text), Projection::parallel), nullptr, points, frame);
		const Extent extent = pictureOf(camera, points, frame);
		const glm::dvec2 filled = (extent.hi - extent.lo) / (frame.free_hi - frame.free_lo);
		EXPECT_GE(std::max(filled.x, filled.y), 0.98) << text;
		// The four edges along each axis have the same length and direction in the picture.
		for (const std::size_t axis : {1u, 2u, 4u})
		{
			const glm::dvec2 first = camera.project(points[axis], frame) - camera.project(points[0], frame);
			for (std::size_t from = 0; from < 8; ++from)
				if (!(from & axis))
				{
					const glm::dvec2 other =
					    camera.project(points[from | axis], frame) - camera.project(points[from], frame);
					EXPECT_LT(glm::length(other - first), 0.6) << text;
				}
		}
	}
	// A fixed camera shows its focal point as large, and its text is the one of perspective.
	const CameraChoice fixed = choice("5,1,2,0,0,1,0,0,1");
	const CameraChoice far = projected(fixed, Projection::parallel);
	const double before =
	    glm::length(fixed.camera.project({0.0, 0.01, 1.0}, frame) - fixed.camera.project({0.0, 0.0, 1.0}, frame));
	const double after =
	    glm::length(far.camera.project({0.0, 0.01, 1.0}, frame) - far.camera.project({0.0, 0.0, 1.0}, frame));
	EXPECT_NEAR(after, before, 2e-3 * before);
	EXPECT_GT(farther(far.camera), 500.0);
	EXPECT_LT(glm::length(fixedCamera(far.camera).camera.position - fixed.camera.position), 1e-9);
	EXPECT_EQ(projected(fixed, Projection::perspective).camera.position, fixed.camera.position);
}

TEST(Camera, LeavesTheCornerToTheAxes)
{
	Frame frame = frameWithLegend();
	const auto square = boxCorners({-2.0, -1.0, 0.0}, {2.0, 1.0, 0.0});
	frame.corner = glm::dvec2(140.0, 590.0);
	const Camera camera = makeCamera(choice("z"), nullptr, square, frame);
	const Extent extent = pictureOf(camera, square, frame);
	EXPECT_TRUE(extent.lo.x >= 140.0 - 1e-6 || extent.hi.y <= 590.0 + 1e-6);
}

TEST(Camera, NamedViewsLookWhereTheySay)
{
	const Frame frame = frameWithLegend();
	const auto points = boxCorners({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
	const auto view = [&](const char* text) { return makeCamera(choice(text), nullptr, points, frame); };
	const auto expectNear = [](const Vec3& a, const Vec3& b) { EXPECT_NEAR(glm::length(a - b), 0.0, 1e-12); };
	expectNear(view("x").forward(), {-1.0, 0.0, 0.0});
	expectNear(view("x").trueUp(), {0.0, 0.0, 1.0});
	expectNear(view("-y").forward(), {0.0, 1.0, 0.0});
	expectNear(view("-y").right(), {1.0, 0.0, 0.0});
	expectNear(view("z").forward(), {0.0, 0.0, -1.0});
	expectNear(view("z").right(), {1.0, 0.0, 0.0});
	expectNear(view("90,0").forward(), {0.0, -1.0, 0.0});
	expectNear(view("0,90").forward(), {0.0, 0.0, -1.0});
	expectNear(view("0,90").trueUp(), {-1.0, 0.0, 0.0});

	const probe::Sheet sheet = probe::makeSheet({0.1, 0.0, 0.0}, {1.0, 2.0, -0.5}, {0.0, 0.0, 1.0});
	const Camera straight = makeCamera(choice("sheet"), &sheet, points, frame);
	expectNear(straight.forward(), -sheet.normal);
	expectNear(straight.trueUp(), sheet.up);
	expectNear(straight.right(), sheet.xAxis());
}

TEST(Camera, TheAutomaticViewSeesTheSheetOpenAndUpright)
{
	const auto points = boxCorners({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
	for (const Vec3& normal :
	     {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0.3, 0.5, 0.81), Vec3(-1, 2, -3)})
	{
		const probe::Sheet sheet = probe::makeSheet({0.0, 0.0, 0.0}, normal);
		const Camera camera = makeCamera({}, &sheet, points, frameWithLegend());
		EXPECT_GE(std::abs(glm::dot(camera.forward(), sheet.normal)), std::cos(0.80));
		EXPECT_LE(camera.forward().z, 0.0);
		EXPECT_GT(camera.trueUp().z, 0.5);
	}
}

TEST(Camera, NineNumbersAreTakenAsTheyAre)
{
	const CameraChoice fixed = choice("1 2 3, 4 5 6, 0 0 1");
	const Camera camera = makeCamera(fixed, nullptr, boxCorners({0, 0, 0}, {9, 9, 9}), frameWithLegend());
	EXPECT_EQ(camera.position, Vec3(1, 2, 3));
	EXPECT_EQ(camera.focal_point, Vec3(4, 5, 6));
	EXPECT_EQ(camera.up, Vec3(0, 0, 1));
	EXPECT_GT(camera.near, 0.0);
}

TEST(Camera, ClipSpaceIsVulkansWithReversedDepth)
{
	Camera camera;
	camera.position = {0.0, 0.0, 10.0};
	camera.near = 2.0;
	const Frame frame{200.0, 100.0, {0.0, 0.0}, {200.0, 100.0}, {}};
	EXPECT_EQ(camera.project({0.0, 0.0, 0.0}, frame), glm::dvec2(100.0, 50.0));
	EXPECT_LT(camera.project({0.0, 1.0, 0.0}, frame).y, 50.0);
	EXPECT_GT(camera.project({1.0, 0.0, 0.0}, frame).x, 100.0);
	const glm::dvec4 clip = camera.projection(2.0) * camera.view() * glm::dvec4(0.3, 0.2, 5.0, 1.0);
	EXPECT_NEAR(clip.z / clip.w, 2.0 / 5.0, 1e-12);
}

TEST(Camera, WhatIsNoViewIsAUsageError)
{
	for (const char* text :
	     {"", "up", "1", "1,2,3", "x,y", "1 1 1 1 1 1 0 0 1", "0 0 1 0 0 0 0 0 0", "30,nan", "30;20"})
	{
		const auto parsed = parseCamera(text);
		ASSERT_FALSE(parsed) << text;
		EXPECT_EQ(parsed.error().kind, ErrorKind::usage);
		EXPECT_EQ(parsed.error().message.find('\n'), std::string::npos);
	}
}

} // namespace vp::render
