#pragma once

#include "probe/probe.h"

#include "exhaustive.h"

#include <gtest/gtest.h>

namespace vp::test
{

inline double between(double lo, double hi, std::mt19937& random)
{
	return std::uniform_real_distribution<double>(lo, hi)(random);
}

inline probe::Frame randomFrame(std::mt19937& random)
{
	const Box box{Vec3(-5.0), Vec3(5.0)};
	const Vec3 origin = randomPoint(box, random);
	const Vec3 normal = randomDirection(random);
	return probe::makeFrame(origin, normal, randomDirection(random));
}

// With fx and a window.
inline probe::Sheet randomSheet(std::mt19937& random)
{
	probe::Sheet sheet{randomFrame(random), {}, {}, {}};
	sheet.fx.magnification = between(0.2, 8.0, random);
	sheet.fx.pan = randomPoint({Vec3(-1.0), Vec3(1.0)}, random);
	const double x0 = between(-3.0, 3.0, random);
	const double y0 = between(-3.0, 3.0, random);
	sheet.window = probe::Window{x0, x0 + between(0.1, 4.0, random), y0, y0 + between(0.1, 4.0, random)};
	return sheet;
}

inline probe::Probe randomProbe(std::mt19937& random)
{
	probe::Probe probe{{}, randomFrame(random), "random"};
	for (int i = 0; i < 4; ++i)
		probe.sheets.push_back(randomSheet(random));
	return probe;
}

inline void expectNear(const Vec3& a, const Vec3& b, double tolerance)
{
	EXPECT_LE(glm::length(a - b), tolerance)
	    << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}

inline void expectNear(const probe::Transform& a, const probe::Transform& b, double tolerance)
{
	for (int row = 0; row < 4; ++row)
		expectNear(a.row[row], b.row[row], tolerance);
}

inline void expectNear(const probe::Frame& a, const probe::Frame& b, double tolerance)
{
	expectNear(a.origin, b.origin, tolerance);
	expectNear(a.normal, b.normal, tolerance);
	expectNear(a.up, b.up, tolerance);
}

} // namespace vp::test
