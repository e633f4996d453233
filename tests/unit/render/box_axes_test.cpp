#include "render/annotate/box_axes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vp::render
{

namespace
{

constexpr Frame kFrame{640.0, 480.0, {0.0, 0.0}, {640.0, 480.0}, {}};
const Box kBox{{-1.0, -2.0, -0.5}, {1.0, 2.0, 0.5}};

Camera from(const Vec3& direction)
{
	Camera camera;
	camera.position = 12.0 * glm::normalize(direction);
	camera.up = {0.0, 0.0, 1.0};
	camera.near = 1.0;
	return camera;
}

} // namespace

TEST(BoxAxes, RunAlongTheContour)
{
	for (const double azimuth : {0.3, 1.2, 2.0, 3.9, 5.5})
		for (const double height : {-1.1, -0.2, 0.4, 1.3})
		{
			const Camera camera = from({std::cos(azimuth), std::sin(azimuth), height});
			const auto edges = axisEdges(kBox, camera, kFrame);
			for (int axis = 0; axis < 3; ++axis)
			{
				ASSERT_TRUE(edges[axis]) << axis;
				Vec3 along(0.0);
				along[axis] = kBox.hi[axis] - kBox.lo[axis];
				EXPECT_EQ(edges[axis]->to - edges[axis]->from, along);
				// No corner of the box lies farther out than the edge.
				const glm::dvec2 at = camera.project(edges[axis]->from, kFrame);
				const glm::dvec2 end = camera.project(edges[axis]->to, kFrame);
				EXPECT_NEAR(glm::dot(end - at, edges[axis]->outward), 0.0, 1e-6);
				EXPECT_NEAR(glm::length(edges[axis]->outward), 1.0, 1e-9);
				for (int i = 0; i < 8; ++i)
				{
					const Vec3 corner{i & 1 ? 1.0 : -1.0, i & 2 ? 2.0 : -2.0, i & 4 ? 0.5 : -0.5};
					EXPECT_LE(glm::dot(camera.project(corner, kFrame) - at, edges[axis]->outward), 1e-6);
				}
			}
		}
}

TEST(BoxAxes, AnAxisSeenEndOnHasNone)
{
	const auto edges = axisEdges(kBox, from({1.0, 0.0, 0.0}), kFrame);
	EXPECT_FALSE(edges[0]);
	EXPECT_TRUE(edges[1]);
	EXPECT_TRUE(edges[2]);
	// Below, and to the left.
	EXPECT_GT(edges[1]->outward.y, 0.9);
	EXPECT_LT(edges[2]->outward.x, -0.9);
}

TEST(BoxAxes, FlatBoxesAndEyesInsideAreNoTrouble)
{
	const Box flat{{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}};
	const auto edges = axisEdges(flat, from({0.3, 0.4, 1.0}), kFrame);
	EXPECT_TRUE(edges[0]);
	EXPECT_TRUE(edges[1]);
	EXPECT_FALSE(edges[2]);
	Camera inside = from({0.3, 0.4, 1.0});
	inside.position = {0.1, 0.1, 0.1};
	inside.focal_point = {1.0, 0.1, 0.1};
	for (const auto& edge : axisEdges(kBox, inside, kFrame))
		EXPECT_FALSE(edge);
}

} // namespace vp::render
