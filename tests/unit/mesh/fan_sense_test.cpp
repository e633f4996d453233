#include "mesh/fan_sense.h"
#include "mesh/tidy_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace vp::test
{

namespace
{

constexpr double kSpan = 4.0; // side of the box that holds all positions

// Returns 1 or -1 for the sense of a polygon, or 0 if it is not clear. The first vertex is repeated up to kCorners.
template <int kCorners>
int senseOf(const Vec3& normal, const std::vector<Vec3>& positions)
{
	std::vector<std::uint32_t> fan(kCorners, 0);
	for (std::uint32_t v = 0; v < positions.size(); ++v)
		fan[v] = v;
	const mesh::FanSense<kCorners> sense(normal, Vec3(kSpan), positions.data());
	const double area = sense.areaOf(fan.data());
	const double checked = sense.checked(area, fan.data());
	if (sense.isClear(std::abs(area)))
	{
		EXPECT_EQ(checked, area);
	}
	return checked > 0.0 ? 1 : checked < 0.0 ? -1 : 0;
}

// Returns the same by the general method.
int senseByTurning(const Vec3& normal, const std::vector<Vec3>& positions)
{
	std::vector<std::uint32_t> polygon(positions.size());
	for (std::uint32_t v = 0; v < polygon.size(); ++v)
		polygon[v] = v;
	if (!mesh::Facing(normal).turn(positions.data(), polygon))
		return 0;
	return polygon[0] == 0 ? 1 : -1;
}

} // namespace

TEST(FanSense, AgreesWithTheGeneralWay)
{
	std::mt19937 random(3);
	std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
	int counts[3] = {};
	for (int n = 0; n < 20000; ++n)
	{
		const Vec3 normal = glm::normalize(Vec3(anywhere(random), anywhere(random), anywhere(random)));
		const Vec3 u = glm::normalize(glm::cross(normal, Vec3(0.3, 0.5, 0.7)));
		const Vec3 v = glm::cross(normal, u);
		const unsigned corners = 3 + random() % 4;
		// Some are as small as cells at a wall, some are lines.
		const double width = random() % 3 ? std::pow(10.0, -static_cast<double>(random() % 8)) : 1.0;
		const double height = random() % 4 ? width * std::pow(10.0, -static_cast<double>(random() % 4)) : 0.0;
		std::vector<Vec3> positions;
		for (unsigned c = 0; c < corners; ++c)
		{
			const double angle = 2.0 * std::numbers::pi * c / corners;
			positions.push_back(width * std::cos(angle) * u + height * std::sin(angle) * v);
		}
		if (random() % 2)
			std::ranges::reverse(positions);
		const int expected = senseByTurning(normal, positions);
		EXPECT_EQ(senseOf<6>(normal, positions), expected) << n;
		if (corners <= 4)
		{
			EXPECT_EQ(senseOf<4>(normal, positions), expected) << n;
		}
		++counts[expected + 1];
	}
	for (const int count : counts)
		EXPECT_GT(count, 2000);
}

} // namespace vp::test
