#pragma once

#include "surface/expression_tree.h"

#include <limits>

namespace vp::surface
{

// All that a value may be, ends included: both finite, or the whole line where that is not known.
struct Interval
{
	double lo = -std::numeric_limits<double>::infinity();
	double hi = std::numeric_limits<double>::infinity();

	static Interval of(double value) { return {value, value}; }

	bool isBounded() const { return lo > -std::numeric_limits<double>::infinity(); }
	bool contains(double value) const { return lo <= value && value <= hi; }
	// False: all of it lies on one side of 0, 0 being with the positive.
	bool hasBothSides() const { return lo < 0.0 && hi >= 0.0; }
	double magnitude() const { return hi > -lo ? hi : -lo; }              // the largest of |value|
	double least() const { return lo > 0.0 ? lo : hi < 0.0 ? -hi : 0.0; } // and the least
};

// The operation on all values of a and b (a alone for operations of one operand). Holds the exact results and what
// doubles make of them: ends are moved outwards by 2^-51 of their size for each operation that IEEE 754 rounds
// correctly, and by 2^-47 for what the C library computes, which is wrong by a few ulps of 2^-53 at most. The whole
// line stands for what may be unbounded or not a number (a pole, a root of what may be negative, an overflow), and
// nothing that is computed from it is bounded again: NaN counts as not positive, so a sign may change there too.
Interval applied(Operation operation, int exponent, const Interval& a, const Interval& b);

} // namespace vp::surface
