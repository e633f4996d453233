#pragma once

#include "surface/expression_tree.h"

#include <limits>

namespace vp::surface
{

// All possible values, ends included. Both ends are finite, or nothing is known and the interval is the whole line.
struct Interval
{
	double lo = -std::numeric_limits<double>::infinity();
	double hi = std::numeric_limits<double>::infinity();

	static Interval of(double value) { return {value, value}; }

	bool isBounded() const { return lo > -std::numeric_limits<double>::infinity(); }
	bool contains(double value) const { return lo <= value && value <= hi; }
	// Returns false if the whole interval lies on one side of 0. 0 counts as positive.
	bool hasBothSides() const { return lo < 0.0 && hi >= 0.0; }
	double magnitude() const { return hi > -lo ? hi : -lo; }              // the largest of |value|
	double least() const { return lo > 0.0 ? lo : hi < 0.0 ? -hi : 0.0; } // and the least
};

// Applies an operation to all values of a and b (only a for operations with one operand). The result contains the exact
// results and those in double. For this, its ends are moved outward by 2^-51 of their size for operations that IEEE 754
// rounds correctly, and by 2^-47 for functions of the C library, whose error is at most a few ulps of 2^-53. If a
// result may be unbounded or NaN (a pole, a root of a negative number, an overflow), the result is the whole line.
// Everything computed from it is the whole line too: NaN counts as not positive, so the sign may change there.
Interval applied(Operation operation, int exponent, const Interval& a, const Interval& b);

} // namespace vp::surface
