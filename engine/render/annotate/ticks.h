#pragma once

#include <string>
#include <vector>

namespace vp::render
{

struct Tick
{
	double value;
	std::string label;
};

// Marks at round values (1, 2 or 5 times a power of ten) within [lo, hi], and their labels. Where plain digits would be
// long, the labels share a power of ten that is told once: "×10⁶".
struct Ticks
{
	std::vector<Tick> marks; // ascending; one, at the value, where lo and hi agree
	std::string factor;      // empty where the labels are the values
};

// At most `most` marks (>= 2). lo and hi are finite; lo > hi is taken as hi, lo.
Ticks makeTicks(double lo, double hi, int most);

// Marks of a logarithmic scale, 0 < lo <= hi: powers of ten, and of narrow ranges parts of them too.
Ticks makeLogTicks(double lo, double hi, int most);

// Marks at given values, ascending: every second, third … of them where there are more than `most`.
Ticks ticksAt(const std::vector<double>& values, int most, bool logarithmic);

// A number for a caption: so many significant digits, a true minus sign, no negative zero.
std::string shortNumber(double value, int significant = 4);

// Significant digits, four at the least, that leave each of some round values, ascending, within a thousandth of their
// least distance from where it was.
int digitsApart(const std::vector<double>& values);

} // namespace vp::render
