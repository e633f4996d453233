#pragma once

#include <array>
#include <cstdint>

namespace vp
{

// A sum of doubles without rounding: every bit of every number is kept. So it does not depend on the order of the
// numbers, nor on how they were parted among threads or processes, and value() is the sum rounded once. Any value that
// is not finite makes the sum what such values add up to.
//
// The bits lie in digits of 32 bits, each in a number of 64 bits, so that many sums fit before digits are carried.
// Adding takes a few nanoseconds. A plain array, which may be sent as bytes.
class ExactSum
{
public:
	ExactSum& operator+=(double value);
	ExactSum& operator+=(const ExactSum& other);
	/// Returns the sum, rounded to the nearest double.
	double value() const;

private:
	static constexpr int kDigits = 68; // digits of 32 bits, from 2^-1074 to past the largest double, with room to carry
	static constexpr std::int64_t kMaxAdded = std::int64_t(1) << 29;

	void carry();

	std::array<std::int64_t, kDigits> digits_{};
	std::int64_t added_ = 0;  // numbers since digits were last carried
	double not_finite_ = 0.0; // the sum of the others
};

} // namespace vp
