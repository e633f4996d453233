#pragma once

#include <cstddef>
#include <vector>

namespace vp::app
{

// A place in a series where its values change.
struct Step
{
	std::size_t at;     // the first value after the change
	double ratio;       // median of the values after it (up to the next step), divided by that of those before it
	double probability; // that a statistic is at least as large if the values come in any order
};

constexpr double kStepRisk = 0.01;       // a step must be this improbable
constexpr std::size_t kShortestStep = 4; // number of values before and after it

// Finds the steps of a series by circular binary segmentation (Olshen, Venkatraman, Lucito and Wigler, 2004): it is
// parted into the stretch whose ranks differ most from those of all other values, by the statistic of Mann and Whitney,
// and what comes before and after it; then each of these is parted again. 999 permutations tell how improbable the
// statistic is. Ranks do not care about the few runs that something disturbed. Returns the steps in ascending order;
// the same values always give the same steps.
std::vector<Step> stepsOf(const std::vector<double>& values);

} // namespace vp::app
