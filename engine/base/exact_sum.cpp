#include "base/exact_sum.h"

#include <bit>
#include <cmath>

namespace vp
{

namespace
{

constexpr int kDigitBits = 32;
constexpr std::int64_t kDigit = std::int64_t(1) << kDigitBits;
constexpr int kMinExponent = -1074; // exponent of the lowest bit of the lowest digit

} // namespace

ExactSum& ExactSum::operator+=(double value)
{
	const auto bits = std::bit_cast<std::uint64_t>(value);
	const auto exponent = static_cast<int>(bits >> 52 & 0x7FF);
	if (exponent == 0x7FF)
	{
		not_finite_ += value;
		return *this;
	}
	std::uint64_t mantissa = bits & 0xF'FFFF'FFFF'FFFFull;
	if (exponent > 0)
		mantissa |= 1ull << 52;
	const int place = exponent > 0 ? exponent - 1 : 0;
	const int digit = place / kDigitBits;
	const int shift = place % kDigitBits;
	// Three digits take the 53 bits, wherever they begin.
	const std::uint64_t low = mantissa << shift;
	const std::uint64_t high = shift ? mantissa >> (64 - shift) : 0;
	const std::int64_t sign = bits >> 63 ? -1 : 1;
	digits_[digit] += sign * static_cast<std::int64_t>(low & (kDigit - 1));
	digits_[digit + 1] += sign * static_cast<std::int64_t>(low >> kDigitBits);
	digits_[digit + 2] += sign * static_cast<std::int64_t>(high);
	if (++added_ >= kMaxAdded)
		carry();
	return *this;
}

ExactSum& ExactSum::operator+=(const ExactSum& other)
{
	for (int i = 0; i < kDigits; ++i)
		digits_[i] += other.digits_[i];
	// Carried digits count as one number.
	added_ += other.added_ + 1;
	not_finite_ += other.not_finite_;
	if (added_ >= kMaxAdded)
		carry();
	return *this;
}

// Leaves digits of 0 to 2^32 - 1, but for the highest, which has the sign.
void ExactSum::carry()
{
	std::int64_t carried = 0;
	for (int i = 0; i + 1 < kDigits; ++i)
	{
		const std::int64_t sum = digits_[i] + carried;
		carried = sum >> kDigitBits;
		digits_[i] = sum & (kDigit - 1);
	}
	digits_[kDigits - 1] += carried;
	added_ = 0;
}

double ExactSum::value() const
{
	if (not_finite_ != 0.0)
		return not_finite_;
	ExactSum sum = *this;
	sum.carry();
	const bool negative = sum.digits_[kDigits - 1] < 0;
	if (negative)
	{
		for (std::int64_t& digit : sum.digits_)
			digit = -digit;
		sum.carry();
	}
	int top = kDigits - 1;
	while (top > 0 && sum.digits_[top] == 0)
		--top;
	// The highest 64 to 96 bits; of what lies below, only whether there is anything matters to the rounding.
	const int lowest = top >= 2 ? top - 2 : 0;
	unsigned __int128 leading = 0;
	for (int i = top; i >= lowest; --i)
		leading = leading << kDigitBits | static_cast<std::uint64_t>(sum.digits_[i]);
	bool is_more = false;
	for (int i = 0; i < lowest; ++i)
		is_more = is_more || sum.digits_[i] != 0;
	if (is_more)
		leading |= 1;
	const double rounded = std::ldexp(static_cast<double>(leading), kMinExponent + kDigitBits * lowest);
	return negative ? -rounded : rounded;
}

} // namespace vp
