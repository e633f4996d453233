#include "refine/factor.h"

#include "grid/curved/curved_types.h"

#include <algorithm>
#include <cmath>

namespace vp::refine
{

namespace
{

constexpr std::size_t kTerms = grid::kMaxDegree + 1;

double factorial(int n)
{
	double product = 1.0;
	for (int i = 2; i <= n; ++i)
		product *= i;
	return product;
}

} // namespace

Factor::Factor(int first, int axes, int degree) : first_(first), axes_(axes), degree_(degree)
{
	for (int k = 0; k <= (axes > 2 ? degree : 0); ++k)
		for (int j = 0; j + k <= (axes > 1 ? degree : k); ++j)
			for (int i = 0; i + j + k <= degree; ++i)
				places_.push_back({i, j, k});
	for (const auto& [i, j, k] : places_)
		choices_.push_back(factorial(degree) /
		                   (factorial(i) * factorial(j) * factorial(k) * factorial(degree - i - j - k)));
	if (degree > 1)
		invert();
}

std::size_t Factor::numberOf(const std::array<int, 3>& place) const
{
	return static_cast<std::size_t>(std::ranges::find(places_, place) - places_.begin());
}

/// power(x, terms): writes the degree + 1 one-dimensional terms of a barycentric coordinate.
template <class Power>
void Factor::weigh(const Vec3& at, double* weights, Power&& power) const
{
	std::array<std::array<double, kTerms>, 4> terms;
	double rest = 1.0;
	for (int a = 0; a < axes_; ++a)
	{
		rest -= at[first_ + a];
		power(at[first_ + a], terms[static_cast<std::size_t>(a)]);
	}
	power(rest, terms[3]);
	if (axes_ == 1)
		for (int i = 0; i <= degree_; ++i)
			weights[i] = terms[0][static_cast<std::size_t>(i)] * terms[3][static_cast<std::size_t>(degree_ - i)];
	else
		for (std::size_t n = 0; n < places_.size(); ++n)
		{
			const auto [i, j, k] = places_[n];
			double product = terms[0][static_cast<std::size_t>(i)] * terms[1][static_cast<std::size_t>(j)];
			if (axes_ == 3)
				product *= terms[2][static_cast<std::size_t>(k)];
			weights[n] = product * terms[3][static_cast<std::size_t>(degree_ - i - j - k)];
		}
}

void Factor::weighLagrange(const Vec3& at, double* weights) const
{
	// Silvester's polynomials: term n is 0 at the first n places of the lattice, and 1 at the next.
	weigh(at, weights,
	      [degree = degree_](double x, std::array<double, kTerms>& terms)
	      {
		      terms[0] = 1.0;
		      for (int n = 0; n < degree; ++n)
			      terms[static_cast<std::size_t>(n) + 1] =
			          terms[static_cast<std::size_t>(n)] * (degree * x - n) / (n + 1);
	      });
}

void Factor::weighBernstein(const Vec3& at, double* weights) const
{
	weigh(at, weights,
	      [degree = degree_](double x, std::array<double, kTerms>& terms)
	      {
		      terms[0] = 1.0;
		      for (int n = 0; n < degree; ++n)
			      terms[static_cast<std::size_t>(n) + 1] = terms[static_cast<std::size_t>(n)] * x;
	      });
	for (std::size_t n = 0; n < places_.size(); ++n)
		weights[n] *= choices_[n];
}

/// By Gauss and Jordan, of the values of Bernstein's polynomials at the lattice.
void Factor::invert()
{
	const std::size_t n = size();
	std::vector<double> matrix(n * n);
	for (std::size_t row = 0; row < n; ++row)
	{
		Vec3 at(0.0);
		for (int a = 0; a < axes_; ++a)
			at[first_ + a] = places_[row][static_cast<std::size_t>(a)] / double(degree_);
		weighBernstein(at, &matrix[row * n]);
	}
	to_bernstein_.assign(n * n, 0.0);
	for (std::size_t row = 0; row < n; ++row)
		to_bernstein_[row * n + row] = 1.0;
	for (std::size_t c = 0; c < n; ++c)
	{
		std::size_t pivot = c;
		for (std::size_t row = c + 1; row < n; ++row)
			if (std::abs(matrix[row * n + c]) > std::abs(matrix[pivot * n + c]))
				pivot = row;
		const auto rowOf = [n](std::vector<double>& of, std::size_t row) { return std::span(of).subspan(row * n, n); };
		std::ranges::swap_ranges(rowOf(matrix, c), rowOf(matrix, pivot));
		std::ranges::swap_ranges(rowOf(to_bernstein_, c), rowOf(to_bernstein_, pivot));
		const double scale = 1.0 / matrix[c * n + c];
		for (std::size_t i = 0; i < n; ++i)
		{
			matrix[c * n + i] *= scale;
			to_bernstein_[c * n + i] *= scale;
		}
		for (std::size_t row = 0; row < n; ++row)
		{
			const double share = matrix[row * n + c];
			if (row == c || share == 0.0)
				continue;
			for (std::size_t i = 0; i < n; ++i)
			{
				matrix[row * n + i] -= share * matrix[c * n + i];
				to_bernstein_[row * n + i] -= share * to_bernstein_[c * n + i];
			}
		}
	}
}

} // namespace vp::refine
