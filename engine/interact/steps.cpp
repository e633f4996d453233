#include "interact/steps.h"

#include "render/scene/round_numbers.h"

#include <cmath>

namespace vp::interact
{

double sizeOf(const Box& bounds)
{
	const double diagonal = bounds.diagonal();
	return diagonal > 0.0 ? diagonal : 1.0;
}

double roundStep(const Box& bounds)
{
	const double wanted = sizeOf(bounds) / 50.0;
	const int exponent = render::decimalExponent(wanted);
	const double m = wanted / std::pow(10.0, exponent);
	// Parted where the ratios to both neighbors are the same.
	const double round = m < std::sqrt(2.0) ? 1.0 : m < std::sqrt(10.0) ? 2.0 : m < std::sqrt(50.0) ? 5.0 : 10.0;
	return render::timesPowerOfTen(round, exponent);
}

double rounded(double value, double step)
{
	return step * std::round(value / step);
}

} // namespace vp::interact
