#include "profile/paired_ratios.h"

#include "profile/spread.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace vp::app
{

namespace
{

constexpr double kRisk = 0.05;
constexpr int kResamples = 1000; // known to 2 % of itself, the error then adds nothing that counts
constexpr std::uint64_t kBootstrapSeed = 1990;

// Returns the probability that a value of Student's distribution lies within +-sqrt(degrees) tan(angle). With this
// substitution the density becomes a power of the cosine, which is integrated by Simpson's rule.
double studentWithin(double angle, std::size_t degrees)
{
	constexpr int kSteps = 400; // even; the error is below 1e-9 up to 1000 degrees of freedom
	const double nu = static_cast<double>(degrees);
	const double scale = std::exp(std::lgamma(0.5 * (nu + 1.0)) - std::lgamma(0.5 * nu)) / std::sqrt(std::numbers::pi);
	const double step = angle / kSteps;
	double sum = 0.0;
	for (int k = 0; k <= kSteps; ++k)
	{
		const double weight = k == 0 || k == kSteps ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
		sum += weight * std::pow(std::cos(k * step), nu - 1.0);
	}
	return std::min(1.0, 2.0 * scale * sum * step / 3.0);
}

// Returns by how much the variance of a mean grows because neighbors in a series are alike: (1 + r) / (1 - r) for a
// series in which each value is r times the one before, and noise (an autoregressive process of order 1). At least 1.
double growthOfVariance(const std::vector<double>& series)
{
	constexpr double kMostAlike = 0.9;
	const double mean = std::accumulate(series.begin(), series.end(), 0.0) / static_cast<double>(series.size());
	double square = 0.0, neighbors = 0.0;
	for (std::size_t i = 0; i < series.size(); ++i)
	{
		square += (series[i] - mean) * (series[i] - mean);
		neighbors += i > 0 ? (series[i] - mean) * (series[i - 1] - mean) : 0.0;
	}
	const double r = square > 0.0 ? std::clamp(neighbors / square, 0.0, kMostAlike) : 0.0;
	return (1.0 + r) / (1.0 - r);
}

} // namespace

double studentQuantile(double confidence, std::size_t degrees)
{
	double low = 0.0, high = 0.5 * std::numbers::pi;
	for (int k = 0; k < 50; ++k)
	{
		const double middle = 0.5 * (low + high);
		(studentWithin(middle, degrees) < confidence ? low : high) = middle;
	}
	return std::sqrt(static_cast<double>(degrees)) * std::tan(low);
}

double RatioEstimate::ratio() const
{
	return std::exp(log);
}

Interval RatioEstimate::interval(double confidence) const
{
	const double half = studentQuantile(confidence, rounds - 1) * error;
	return {std::exp(log - half), std::exp(log + half)};
}

double RatioEstimate::chance() const
{
	if (rounds < 2 || log == 0.0)
		return 1.0;
	const double t = std::abs(log) / error; // infinite if no ratio differs from another
	return 1.0 - studentWithin(std::atan(t / std::sqrt(static_cast<double>(rounds - 1))), rounds - 1);
}

void PairedRatios::add(std::size_t round, double first, double other)
{
	if (rounds_.empty() || rounds_.back() != round)
		rounds_.push_back(round);
	pairs_.push_back({std::log(other / first), rounds_.size() - 1});
}

RatioEstimate PairedRatios::estimate() const
{
	std::vector<Pair> sorted = pairs_;
	std::ranges::sort(sorted, {}, &Pair::log);
	std::vector<std::size_t> sizes(rounds_.size());
	std::vector<std::vector<double>> logs(rounds_.size());
	for (const Pair& pair : sorted)
	{
		++sizes[pair.round];
		logs[pair.round].push_back(pair.log);
	}
	// The median if each round counts as often as it was drawn.
	const auto medianOfDrawn = [&](const std::vector<std::size_t>& drawn)
	{
		const std::size_t all = std::inner_product(sizes.begin(), sizes.end(), drawn.begin(), std::size_t(0));
		std::size_t passed = 0;
		for (auto pair = sorted.begin(); pair != sorted.end(); ++pair)
		{
			passed += drawn[pair->round];
			if (2 * passed < all)
				continue;
			if (2 * passed > all)
				return pair->log;
			const auto next =
			    std::find_if(pair + 1, sorted.end(), [&](const Pair& other) { return drawn[other.round] > 0; });
			return 0.5 * (pair->log + next->log);
		}
		return 0.0;
	};

	RatioEstimate estimate{.rounds = rounds_.size()};
	estimate.log = medianOfDrawn(std::vector<std::size_t>(rounds_.size(), 1));
	if (rounds_.size() < 2)
		return estimate;
	std::mt19937_64 random(kBootstrapSeed);
	double square = 0.0;
	for (int k = 0; k < kResamples; ++k)
	{
		std::vector<std::size_t> drawn(rounds_.size(), 0);
		for (std::size_t i = 0; i < drawn.size(); ++i)
			++drawn[random() % drawn.size()];
		const double off = medianOfDrawn(drawn) - estimate.log;
		square += off * off;
	}
	// A bootstrap of n draws sees a variance that is too small by (n - 1) / n. And it takes rounds for independent,
	// while one program may be on the slower core for several of them.
	const double n = static_cast<double>(rounds_.size());
	std::vector<double> medians;
	for (const std::vector<double>& round : logs)
		medians.push_back(medianOf(round));
	estimate.error = std::sqrt(square / kResamples * n / (n - 1.0) * growthOfVariance(medians));
	return estimate;
}

std::vector<double> holmConfidences(const std::vector<double>& chances)
{
	std::vector<std::size_t> order(chances.size());
	std::iota(order.begin(), order.end(), std::size_t(0));
	std::ranges::stable_sort(order, {}, [&](std::size_t k) { return chances[k]; });
	std::vector<double> confidences(chances.size());
	std::size_t left = chances.size();
	for (const std::size_t k : order)
	{
		const double risk = kRisk / static_cast<double>(left);
		confidences[k] = 1.0 - risk;
		// From the first one on that may be chance, all are judged alike.
		if (chances[k] <= risk)
			--left;
	}
	return confidences;
}

} // namespace vp::app
