#pragma once

#include "grid/field.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace vp::grid
{

// Calls visit(T{}), with T the C++ type of the numbers, and returns its result.
template <class Visit>
auto withNumberType(NumberType type, Visit&& visit)
{
	switch (type)
	{
	case NumberType::int8:
		return visit(std::int8_t{});
	case NumberType::uint8:
		return visit(std::uint8_t{});
	case NumberType::int16:
		return visit(std::int16_t{});
	case NumberType::uint16:
		return visit(std::uint16_t{});
	case NumberType::int32:
		return visit(std::int32_t{});
	case NumberType::uint32:
		return visit(std::uint32_t{});
	case NumberType::int64:
		return visit(std::int64_t{});
	case NumberType::uint64:
		return visit(std::uint64_t{});
	case NumberType::float32:
		return visit(float{});
	case NumberType::float64:
		break;
	}
	return visit(double{});
}

// Returns number `index` of an array as double. Mapped files give no promise about alignment.
template <class T>
double numberAt(const std::byte* bytes, std::size_t index)
{
	T number;
	std::memcpy(&number, bytes + index * sizeof(T), sizeof(T));
	return static_cast<double>(number);
}

// Writes a number as T. Integers are rounded towards zero, and NaN becomes 0.
template <class T>
void storeAs(double value, std::byte* at)
{
	const T number = std::is_integral_v<T> && std::isnan(value) ? T{} : static_cast<T>(value);
	std::memcpy(at, &number, sizeof(T));
}

} // namespace vp::grid
