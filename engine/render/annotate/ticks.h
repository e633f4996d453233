#pragma once

#include "render/scene/round_numbers.h"

#include <string>
#include <vector>

namespace vp::render
{

struct Tick
{
	double value;
	std::string label;
};

// Marks at round values (1, 2 or 5 times a power of ten) in [lo, hi], and their labels. If plain digits would be long,
// the labels share a power of ten that is written once: "×10⁶".
struct Ticks
{
	std::vector<Tick> marks; // ascending; one, at the value, if lo and hi are equal
	std::string factor;      // empty if the labels are the values
	int exponent = 0;        // the factor is 10 to this power
};

// Places are not in single precision: far from the origin, the marks of a narrow axis still differ.
constexpr double kNarrowestAxis = 1e-13;

// Returns at most `most` marks (>= 2). lo and hi must be finite; if lo > hi, they are exchanged. A range narrower than
// a part of its values has one mark.
Ticks makeTicks(double lo, double hi, int most, double narrowest = kNarrowestRange);

// Returns marks of a logarithmic scale, 0 < lo <= hi: powers of ten, and for narrow ranges also parts of them.
Ticks makeLogTicks(double lo, double hi, int most);

// Returns marks at given ascending values. If there are more than `most`, only every second, third … of them.
Ticks ticksAt(const std::vector<double>& values, int most, bool logarithmic);

// Adds marks at the ends of a scale, lo < hi, whose labels are rounded to a thousandth of it. Other marks of the scale
// nearer to an end than `apart`, a share of the scale, are left out. A scale so narrow that it has one mark stays as it
// is.
void addEnds(Ticks& ticks, double lo, double hi, double apart, bool logarithmic);

// Returns a number for a caption, with the given number of significant digits, a true minus sign and no negative zero.
std::string shortNumber(double value, int significant = 4);

// Returns the number of significant digits, at least four, that moves none of some ascending round values by more than
// a thousandth of their least distance.
int digitsApart(const std::vector<double>& values);

} // namespace vp::render
