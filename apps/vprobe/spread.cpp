#include "spread.h"

#include <algorithm>
#include <cmath>

namespace vp::app
{

namespace
{

// The smallest value that so large a part of all are not above.
double quantile(std::vector<double> values, double part)
{
	if (values.empty())
		return 0.0;
	const double rank = std::ceil(part * static_cast<double>(values.size()));
	const auto at = values.begin() + std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(rank) - 1);
	std::ranges::nth_element(values, at);
	return *at;
}

double noiseOf(const std::vector<double>& values)
{
	std::vector<double> distances;
	for (std::size_t k = 1; k + 1 < values.size(); ++k)
		distances.push_back(std::abs(values[k] - 0.5 * (values[k - 1] + values[k + 1])));
	// Of a normal distribution the median distance is 1 / 1.4826 of the deviation; that of a value from the mean of
	// two others has sqrt(1 + 1/2) of its own.
	return 1.4826 / std::sqrt(1.5) * medianOf(std::move(distances));
}

} // namespace

double medianOf(std::vector<double> values)
{
	const double upper = quantile(values, 0.5 + 0.5 / std::max<double>(1.0, static_cast<double>(values.size())));
	return 0.5 * (quantile(std::move(values), 0.5) + upper);
}

Spread spreadOf(const std::vector<double>& values)
{
	return {medianOf(values), quantile(values, 0.95), noiseOf(values)};
}

nlohmann::json asJson(const Spread& spread)
{
	return {{"median", spread.median}, {"p95", spread.p95}, {"noise", spread.noise}};
}

} // namespace vp::app
