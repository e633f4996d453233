#pragma once

#include "base/ids.h"
#include "probe/sheet.h"

#include <cmath>
#include <random>

namespace vp::test
{

// About the sheet's origin or beside it, from far below a cell to the whole slice.
inline probe::Window randomWindow(const Box& bounds, std::mt19937& random)
{
	const double size = bounds.diagonal();
	std::uniform_real_distribution<double> place(-0.4, 0.4);
	std::uniform_real_distribution<double> exponent(-3.0, 0.0);
	const double x = place(random) * size;
	const double y = place(random) * size;
	return {x, x + size * std::pow(10.0, exponent(random)), y, y + size * std::pow(10.0, exponent(random))};
}

} // namespace vp::test
