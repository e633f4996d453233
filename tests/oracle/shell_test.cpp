#include "sliced_sheet.h"

#include "grid/demo/demo.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

constexpr double kPi = std::numbers::pi;
constexpr double kLatitude = 0.45 * kPi; // the shell ends here, north and south

double areaOf(int n, const TestPlane& plane)
{
	const grid::BlockSet set = std::move(grid::makeDemo("shell", n).value());
	cut::Cutter cutter(set);
	return measure::measure(set, cut(cutter, plane).mesh, {}).area;
}

// z = c cuts half a ring: r from 1 to 3 at latitudes whose sine is c / r.
double ringArea(double c)
{
	const auto distance_from_axis = [&](double r) { return std::sqrt(r * r - c * c); };
	const double innermost = std::max(1.0, c / std::sin(kLatitude));
	const double inner = distance_from_axis(innermost);
	const double outer = distance_from_axis(3.0);
	return 0.5 * kPi * (outer * outer - inner * inner);
}

// The error falls to a quarter, or nearly, with every doubling: cells with straight edges in a round shell.
void expectSecondOrder(const TestPlane& plane, double exact)
{
	double previous = 0.0;
	for (const int n : {8, 16, 32, 64})
	{
		const double error = std::abs(areaOf(n, plane) - exact) / exact;
		if (previous > 0.0)
		{
			EXPECT_LT(error, previous / 3.2) << "n " << n;
		}
		previous = error;
	}
	EXPECT_LT(previous, 2e-3);
}

} // namespace

TEST(Shell, PlanesAcrossTheAxisCutHalfRings)
{
	expectSecondOrder({{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, ringArea(0.0));
	expectSecondOrder({{0.0, 0.0, 0.4}, {0.0, 0.0, 1.0}}, ringArea(0.4));
}

TEST(Shell, PlanesThroughTheAxisCutSectors)
{
	const double sector = kLatitude * (3.0 * 3.0 - 1.0); // half the angle from south to north, times r squared
	for (const double longitude : {0.2, 1.1, 2.5})
		expectSecondOrder({Vec3(0.0), {-std::sin(longitude), std::cos(longitude), 0.0}}, sector);
}

// The cut of its ball: half a disc less half a disc, the poles cut away by cones.
TEST(Shell, AreaConvergesForAnyPlane)
{
	for (const TestPlane& plane : randomPlanes({{-1.5, 0.5, -1.5}, {1.5, 1.5, 1.5}}, 5, 110))
	{
		const double finest = areaOf(96, plane);
		const double coarse = std::abs(areaOf(12, plane) - finest);
		const double fine = std::abs(areaOf(48, plane) - finest);
		EXPECT_LT(coarse, 0.05 * finest);
		EXPECT_LT(fine, coarse / 5.0 + 1e-4 * finest);
	}
}

} // namespace vp::test
