#include "dicom_values.h"

#include "dicom_form.h"
#include "vprobe-read/base/bytes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::reader::volumes
{

using grid::NumberType;

namespace
{

bool isWhole(double number)
{
	return number == std::floor(number);
}

// Whether every integer from low to high, times the slope and plus the intercept, is a float32. It is where all are
// multiples of one power of two, and no more than 2^24 of it.
bool isExactInFloat(double low, double high, double slope, double intercept)
{
	constexpr int kMaxHalvings = 20;
	const double largest = std::max(std::abs(low), std::abs(high)) * std::abs(slope) + std::abs(intercept);
	for (int halvings = 0; halvings <= kMaxHalvings; ++halvings)
		if (isWhole(std::ldexp(slope, halvings)) && isWhole(std::ldexp(intercept, halvings)))
			return std::ldexp(largest, halvings) <= 16777216.0;
	return false;
}

template <class Number>
bool holds(double low, double high, unsigned bits)
{
	return sizeof(Number) * 8 >= bits && low >= static_cast<double>(std::numeric_limits<Number>::lowest()) &&
	       high <= static_cast<double>(std::numeric_limits<Number>::max());
}

template <class Number>
void rescaleAs(const std::vector<double>& values, double slope, double intercept, char* to)
{
	for (std::size_t i = 0; i < values.size(); ++i, to += sizeof(Number))
		putNumber(static_cast<Number>(slope * values[i] + intercept), to);
}

} // namespace

void DicomValueType::add(const DicomPixelForm& form, double slope, double intercept)
{
	const auto [low, high] = form.range();
	const double a = slope * low + intercept;
	const double b = slope * high + intercept;
	low_ = is_empty_ ? std::min(a, b) : std::min({low_, a, b});
	high_ = is_empty_ ? std::max(a, b) : std::max({high_, a, b});
	is_empty_ = false;
	bits_ = std::max(bits_, form.allocated);
	is_signed_ = is_signed_ || form.is_signed;
	if (form.is_real)
	{
		is_integer_ = false;
		is_float_ = is_float_ && form.allocated == 32 && slope == 1.0 && intercept == 0.0;
		return;
	}
	is_integer_ = is_integer_ && isWhole(slope) && isWhole(intercept);
	is_float_ = is_float_ && isExactInFloat(low, high, slope, intercept);
}

NumberType DicomValueType::type() const
{
	constexpr double kExact = 9007199254740992.0; // up to here, a double holds every integer
	if (!is_integer_ || low_ < -kExact || high_ > kExact)
		return is_float_ ? NumberType::float32 : NumberType::float64;
	if (low_ >= 0.0 && !is_signed_)
	{
		if (holds<std::uint8_t>(low_, high_, bits_))
			return NumberType::uint8;
		if (holds<std::uint16_t>(low_, high_, bits_))
			return NumberType::uint16;
		if (holds<std::uint32_t>(low_, high_, bits_))
			return NumberType::uint32;
	}
	if (holds<std::int8_t>(low_, high_, bits_))
		return NumberType::int8;
	if (holds<std::int16_t>(low_, high_, bits_))
		return NumberType::int16;
	if (holds<std::int32_t>(low_, high_, bits_))
		return NumberType::int32;
	return NumberType::int64;
}

void rescale(const std::vector<double>& values, double slope, double intercept, NumberType type, char* to)
{
	switch (type)
	{
	case NumberType::int8:
		return rescaleAs<std::int8_t>(values, slope, intercept, to);
	case NumberType::uint8:
		return rescaleAs<std::uint8_t>(values, slope, intercept, to);
	case NumberType::int16:
		return rescaleAs<std::int16_t>(values, slope, intercept, to);
	case NumberType::uint16:
		return rescaleAs<std::uint16_t>(values, slope, intercept, to);
	case NumberType::int32:
		return rescaleAs<std::int32_t>(values, slope, intercept, to);
	case NumberType::uint32:
		return rescaleAs<std::uint32_t>(values, slope, intercept, to);
	case NumberType::int64:
	case NumberType::uint64:
		return rescaleAs<std::int64_t>(values, slope, intercept, to);
	case NumberType::float32:
		return rescaleAs<float>(values, slope, intercept, to);
	case NumberType::float64:
		return rescaleAs<double>(values, slope, intercept, to);
	}
}

} // namespace vp::reader::volumes
