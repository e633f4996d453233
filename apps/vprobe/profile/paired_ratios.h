#pragma once

#include <cstddef>
#include <vector>

namespace vp::app
{

struct Interval
{
	double low = 0.0;
	double high = 0.0;

	bool contains(double value) const { return low <= value && value <= high; }
};

// The median of the ratios of many pairs of times, and how far off it may be. Its distribution is taken on the scale of
// logarithms, where a ratio and its inverse are equally far from 1.
struct RatioEstimate
{
	double log = 0.0;       // logarithm of the median
	double error = 0.0;     // its standard error
	std::size_t rounds = 0; // in which there was a pair

	double ratio() const;
	// Returns the interval that holds the true ratio in `confidence` of all runs, such as 0.95. It needs two rounds.
	Interval interval(double confidence) const;
	// Returns the probability of a median at least as far from 1 if the true ratio is 1.
	double chance() const;
};

// Collects the ratios of pairs that were measured in turns.
class PairedRatios
{
public:
	// Times of one plane in one round, both above 0. Rounds come in ascending order.
	void add(std::size_t round, double first, double other);
	std::size_t rounds() const { return rounds_.size(); }

	// The error comes from a bootstrap over rounds: rounds are drawn with replacement, each with all its pairs, since
	// what disturbs the machine lasts longer than one pair (Efron and Tibshirani, "An Introduction to the Bootstrap",
	// 1993, chapter 8). It grows where neighboring rounds are alike. The drawing is the same in every run.
	RatioEstimate estimate() const;

private:
	struct Pair
	{
		double log;
		std::size_t round; // counted from 0, over the rounds that have a pair
	};

	std::vector<Pair> pairs_;
	std::vector<std::size_t> rounds_;
};

// Returns the confidence of the interval of each of several estimates, so that with 95 % probability all intervals of
// ratios that are truly 1 contain 1. (Holm, "A Simple Sequentially Rejective Multiple Test Procedure", 1979.)
//
// chances: RatioEstimate::chance() of each.
std::vector<double> holmConfidences(const std::vector<double>& chances);

// Returns how far from 0 a value of Student's distribution lies at most with a probability.
double studentQuantile(double confidence, std::size_t degrees);

} // namespace vp::app
