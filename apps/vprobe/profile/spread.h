#pragma once

#include <nlohmann/json.hpp>

#include <vector>

namespace vp::app
{

// Summarizes a figure that was measured once on each plane of a sweep.
struct Spread
{
	double median = 0.0;
	double p95 = 0.0; // 95 of 100 measurements are not above it
	// How much one measurement is off by chance. This is the standard deviation about the mean of the two neighbors,
	// estimated by the median of the distances from that mean, since along a sweep the work itself changes slowly
	// (Gasser, Sroka and Jennen-Steinmetz, "Residual variance and residual pattern in nonlinear regression", 1986). It
	// is 0 if there are fewer than three measurements.
	double noise = 0.0;
};

// values: in the order in which they were measured. Without values, every figure is 0.
Spread spreadOf(const std::vector<double>& values);

double medianOf(const std::vector<double>& values); // 0 without values

nlohmann::json asJson(const Spread& spread);

} // namespace vp::app
