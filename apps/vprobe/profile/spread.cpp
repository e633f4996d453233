#include "profile/spread.h"

#include <algorithm>
#include <cmath>

namespace vp::app
{

namespace
{

// Returns the value at a place, counted from 0, of the sorted values.
double ranked(std::vector<double> values, std::size_t place)
{
	const auto at = values.begin() + static_cast<std::ptrdiff_t>(place);
	std::ranges::nth_element(values, at);
	return *at;
}

// Returns the smallest value that 95 of 100 values do not exceed.
double percentile95(const std::vector<double>& values)
{
	return values.empty() ? 0.0 : ranked(values, (95 * values.size() + 99) / 100 - 1);
}

double noiseOf(const std::vector<double>& values)
{
	std::vector<double> distances;
	for (std::size_t k = 1; k + 1 < values.size(); ++k)
		distances.push_back(std::abs(values[k] - 0.5 * (values[k - 1] + values[k + 1])));
	// In a normal distribution, the median distance is 1 / 1.4826 of the standard deviation. The distance of a value
	// from the mean of two others has sqrt(1 + 1/2) times the deviation of one value.
	return 1.4826 / std::sqrt(1.5) * medianOf(distances);
}

} // namespace

double medianOf(const std::vector<double>& values)
{
	if (values.empty())
		return 0.0;
	return 0.5 * (ranked(values, (values.size() - 1) / 2) + ranked(values, values.size() / 2));
}

Spread spreadOf(const std::vector<double>& values)
{
	return {medianOf(values), percentile95(values), noiseOf(values)};
}

nlohmann::json asJson(const Spread& spread)
{
	return {{"median", spread.median}, {"p95", spread.p95}, {"noise", spread.noise}};
}

} // namespace vp::app
