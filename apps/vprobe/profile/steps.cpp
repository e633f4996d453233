#include "profile/steps.h"

#include "profile/spread.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>

namespace vp::app
{

namespace
{

constexpr int kPermutations = 999;
constexpr std::uint64_t kStepSeed = 1947; // the year of Mann's and Whitney's paper

// Ranks from 1 on; equal values share the mean of theirs.
std::vector<double> ranksOf(std::span<const double> values)
{
	std::vector<std::size_t> order(values.size());
	std::iota(order.begin(), order.end(), std::size_t(0));
	std::ranges::sort(order, {}, [&](std::size_t k) { return values[k]; });
	std::vector<double> ranks(values.size());
	for (std::size_t first = 0; first < order.size();)
	{
		std::size_t end = first;
		while (end < order.size() && values[order[end]] == values[order[first]])
			++end;
		for (std::size_t k = first; k < end; ++k)
			ranks[order[k]] = 0.5 * static_cast<double>(first + 1 + end);
		first = end;
	}
	return ranks;
}

// The part of a series that differs most from the rest of it.
struct Parting
{
	std::size_t begin = 0, end = 0;
	double statistic = 0.0; // in standard deviations
};

Parting bestParting(const std::vector<double>& ranks)
{
	const std::size_t count = ranks.size();
	const double n = static_cast<double>(count);
	std::vector<double> sums(count + 1, 0.0); // the ranks before each place, summed
	std::partial_sum(ranks.begin(), ranks.end(), sums.begin() + 1);
	std::vector<double> deviations(count + 1, 1.0); // by the number of values in the part
	for (std::size_t k = 1; k < count; ++k)
		deviations[k] = std::sqrt(static_cast<double>(k * (count - k)) * (n + 1.0) / 12.0);
	Parting best;
	for (std::size_t begin = 0; begin + kShortestStep <= count; begin += begin == 0 ? kShortestStep : 1)
		for (std::size_t end = begin + kShortestStep; end <= count; ++end)
		{
			const bool is_whole = begin == 0 && end == count;
			if (is_whole || (end < count && end + kShortestStep > count))
				continue;
			const double inside = static_cast<double>(end - begin);
			const double off = std::abs(sums[end] - sums[begin] - 0.5 * inside * (n + 1.0));
			if (const double statistic = off / deviations[end - begin]; statistic > best.statistic)
				best = {begin, end, statistic};
		}
	return best;
}

void findSteps(std::span<const double> values, std::size_t first, std::vector<Step>& steps)
{
	if (values.size() < 2 * kShortestStep)
		return;
	std::vector<double> ranks = ranksOf(values);
	const Parting found = bestParting(ranks);
	if (found.statistic == 0.0)
		return;
	std::mt19937_64 random(kStepSeed);
	int as_large = 1; // the series itself
	for (int k = 0; k < kPermutations && as_large <= kStepRisk * (kPermutations + 1); ++k)
	{
		for (std::size_t i = ranks.size() - 1; i > 0; --i)
			std::swap(ranks[i], ranks[random() % (i + 1)]);
		// Sums of the same ranks in another order may differ by rounding.
		as_large += bestParting(ranks).statistic >= found.statistic - 1e-9;
	}
	const double probability = static_cast<double>(as_large) / (kPermutations + 1);
	if (probability > kStepRisk)
		return;
	findSteps(values.first(found.begin), first, steps);
	if (found.begin > 0)
		steps.push_back({first + found.begin, 1.0, probability});
	findSteps(values.subspan(found.begin, found.end - found.begin), first + found.begin, steps);
	if (found.end < values.size())
		steps.push_back({first + found.end, 1.0, probability});
	findSteps(values.subspan(found.end), first + found.end, steps);
}

} // namespace

std::vector<Step> stepsOf(const std::vector<double>& values)
{
	std::vector<Step> steps;
	findSteps(values, 0, steps);
	const auto medianFrom = [&](std::size_t begin, std::size_t end)
	{
		return medianOf(
		    {values.begin() + static_cast<std::ptrdiff_t>(begin), values.begin() + static_cast<std::ptrdiff_t>(end)});
	};
	for (std::size_t k = 0; k < steps.size(); ++k)
	{
		const std::size_t before = k == 0 ? 0 : steps[k - 1].at;
		const std::size_t after = k + 1 == steps.size() ? values.size() : steps[k + 1].at;
		steps[k].ratio = medianFrom(steps[k].at, after) / medianFrom(before, steps[k].at);
	}
	return steps;
}

} // namespace vp::app
