#include "render/scene/levels.h"

#include "render/scene/round_numbers.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>

namespace vp::render
{

namespace
{

// More are made for no candidate: it would not be chosen.
constexpr int kMaxCandidates = 4 * kMaxLevels;

// Takes candidates and keeps the one whose number of levels is nearest to what was asked for; of two, the one with
// fewer.
class Choice
{
public:
	// A level at the range's very ends would be a line along an edge.
	Choice(double lo, double hi, int about, bool logarithmic)
	    : from_(logarithmic ? lo * (1.0 + kSlack) : lo + kSlack * (hi - lo)),
	      to_(logarithmic ? hi * (1.0 - kSlack) : hi - kSlack * (hi - lo)), about_(about)
	{
	}

	void offer(const std::vector<double>& values)
	{
		std::vector<double> inside;
		std::copy_if(values.begin(), values.end(), std::back_inserter(inside),
		             [this](double v) { return v > from_ && v < to_; });
		if (inside.empty())
			return;
		const int count = static_cast<int>(inside.size());
		const int best = static_cast<int>(best_.size());
		const int nearer = std::abs(count - about_) - std::abs(best - about_);
		if (best == 0 || nearer < 0 || (nearer == 0 && count < best))
			best_ = std::move(inside);
	}
	std::vector<double> best() const { return best_; }

private:
	static constexpr double kSlack = 1e-6;

	double from_;
	double to_;
	int about_;
	std::vector<double> best_;
};

// Multiples of m 10^e.
std::vector<double> multiples(double lo, double hi, double m, int e)
{
	const double step = timesPowerOfTen(m, e);
	std::vector<double> values;
	const double first = std::ceil(lo / step);
	const double last = std::floor(hi / step);
	if (last - first >= kMaxCandidates)
		return values;
	for (double i = first; i <= last; i += 1.0)
		values.push_back(i == 0.0 ? 0.0 : timesPowerOfTen(i * m, e)); // no negative zero
	return values;
}

void offerMultiples(double lo, double hi, int about, Choice& choice)
{
	const int exponent = decimalExponent((hi - lo) / (about + 1));
	for (int e = exponent + 1; e >= exponent - 1; --e)
		for (const double m : {5.0, 2.5, 2.0, 1.0})
			choice.offer(multiples(lo, hi, m, e));
}

// Returns the digits times the power of ten, for every `stride`-th decade.
std::vector<double> ofDecades(double lo, double hi, int stride, std::initializer_list<int> digits)
{
	std::vector<double> values;
	const int first = decimalExponent(lo);
	const int last = decimalExponent(hi);
	for (int e = first; e <= last; ++e)
		if (e % stride == 0)
			for (const int digit : digits)
				values.push_back(timesPowerOfTen(digit, e));
	return values;
}

} // namespace

std::vector<double> roundLevels(double lo, double hi, int about, bool logarithmic)
{
	about = std::clamp(about, 0, kMaxLevels);
	const double largest = std::max(std::abs(lo), std::abs(hi));
	if (about == 0 || !(hi - lo > kNarrowestRange * largest) || !std::isfinite(hi - lo))
		return {};
	Choice choice(lo, hi, about, logarithmic);
	if (!logarithmic)
	{
		offerMultiples(lo, hi, about, choice);
		return choice.best();
	}
	for (const int stride : {1, 2, 3, 5, 10, 20, 50, 100})
		choice.offer(ofDecades(lo, hi, stride, {1}));
	choice.offer(ofDecades(lo, hi, 1, {1, 3}));
	choice.offer(ofDecades(lo, hi, 1, {1, 2, 5}));
	choice.offer(ofDecades(lo, hi, 1, {1, 2, 3, 4, 5, 6, 7, 8, 9}));
	if (hi < 10.0 * lo)
		offerMultiples(lo, hi, about, choice);
	return choice.best();
}

} // namespace vp::render
