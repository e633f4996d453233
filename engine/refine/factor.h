#pragma once

#include "base/vec.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace vp::refine
{

/// Polynomials of one degree along one axis of a cell, or over the triangle or the tetrahedron of two or three axes.
/// The functions of a hexahedron are products over three lines, those of a wedge over a triangle and a line.
class Factor
{
public:
	/// first: its first axis. axes: 1 to 3.
	Factor(int first, int axes, int degree);

	int first() const { return first_; }
	int axes() const { return axes_; }
	int degree() const { return degree_; }
	std::size_t size() const { return places_.size(); }
	/// The places of the lattice, by its own axes; others are 0.
	const std::vector<std::array<int, 3>>& places() const { return places_; }
	std::size_t numberOf(const std::array<int, 3>& place) const;

	/// Writes size() numbers: Lagrange's polynomials of the lattice, exactly 0 and 1 on it.
	void weighLagrange(const Vec3& at, double* weights) const;
	/// The same of Bernstein's polynomials.
	void weighBernstein(const Vec3& at, double* weights) const;

	/// A square matrix, row by row, that makes Bernstein's coefficients of the values at the lattice.
	std::span<const double> toBernstein() const { return to_bernstein_; }

private:
	template <class Power>
	void weigh(const Vec3& at, double* weights, Power&& power) const;
	void invert();

	int first_;
	int axes_;
	int degree_;
	std::vector<std::array<int, 3>> places_;
	std::vector<double> choices_; // multinomial coefficients
	std::vector<double> to_bernstein_;
};

} // namespace vp::refine
