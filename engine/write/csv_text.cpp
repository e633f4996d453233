#include "write/csv_text.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <iterator>

namespace vp::write
{

namespace
{

template <class T>
void appendTuple(std::string& row, const std::byte* at, int components)
{
	for (int c = 0; c < components; ++c)
	{
		T number;
		std::memcpy(&number, at + c * sizeof(T), sizeof(T));
		// int8 is a number here, not a letter.
		if constexpr (sizeof(T) == 1)
			fmt::format_to(std::back_inserter(row), ",{}", static_cast<int>(number));
		else
			fmt::format_to(std::back_inserter(row), ",{}", number);
	}
}

} // namespace

void appendNumbers(std::string& row, grid::NumberType type, const std::byte* at, int components)
{
	using grid::NumberType;
	switch (type)
	{
	case NumberType::int8:
		return appendTuple<std::int8_t>(row, at, components);
	case NumberType::uint8:
		return appendTuple<std::uint8_t>(row, at, components);
	case NumberType::int16:
		return appendTuple<std::int16_t>(row, at, components);
	case NumberType::uint16:
		return appendTuple<std::uint16_t>(row, at, components);
	case NumberType::int32:
		return appendTuple<std::int32_t>(row, at, components);
	case NumberType::uint32:
		return appendTuple<std::uint32_t>(row, at, components);
	case NumberType::int64:
		return appendTuple<std::int64_t>(row, at, components);
	case NumberType::uint64:
		return appendTuple<std::uint64_t>(row, at, components);
	case NumberType::float32:
		return appendTuple<float>(row, at, components);
	case NumberType::float64:
		return appendTuple<double>(row, at, components);
	}
}

} // namespace vp::write
