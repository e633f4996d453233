#include "write/xml_array.h"

#include "base/parallel_reduce.h"
#include "write/unique_names.h"
#include "write/xml_text.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace vp::write
{

namespace
{

struct Range
{
	double least = std::numeric_limits<double>::infinity();
	double greatest = -std::numeric_limits<double>::infinity();

	// NaN is neither less nor greater.
	void include(double low, double high)
	{
		least = low < least ? low : least;
		greatest = high > greatest ? high : greatest;
	}
};

// Returns the range of the values. For vectors it is the range of their squared lengths.
template <class T>
Range rangeOf(const std::byte* numbers, std::size_t tuples, std::size_t components)
{
	const auto number = [&](std::size_t i)
	{
		T value;
		std::memcpy(&value, numbers + i * sizeof(T), sizeof(T));
		return static_cast<double>(value);
	};
	const auto include = [&](const tbb::blocked_range<std::size_t>& part, Range range)
	{
		for (std::size_t t = part.begin(); t < part.end(); ++t)
		{
			double value = number(t * components);
			if (components > 1)
			{
				value *= value;
				for (std::size_t c = 1; c < components; ++c)
				{
					const double next = number(t * components + c);
					value += next * next;
				}
			}
			range.include(value, value);
		}
		return range;
	};
	const auto join = [](Range a, const Range& b)
	{
		a.include(b.least, b.greatest);
		return a;
	};
	constexpr std::size_t kGrain = 65536;
	return parallelReduce(tuples, kGrain, Range{}, include, join);
}

Range rangeOf(grid::NumberType type, const std::byte* numbers, std::size_t tuples, std::size_t components)
{
	switch (type)
	{
	case grid::NumberType::int8:
		return rangeOf<std::int8_t>(numbers, tuples, components);
	case grid::NumberType::uint8:
		return rangeOf<std::uint8_t>(numbers, tuples, components);
	case grid::NumberType::int16:
		return rangeOf<std::int16_t>(numbers, tuples, components);
	case grid::NumberType::uint16:
		return rangeOf<std::uint16_t>(numbers, tuples, components);
	case grid::NumberType::int32:
		return rangeOf<std::int32_t>(numbers, tuples, components);
	case grid::NumberType::uint32:
		return rangeOf<std::uint32_t>(numbers, tuples, components);
	case grid::NumberType::int64:
		return rangeOf<std::int64_t>(numbers, tuples, components);
	case grid::NumberType::uint64:
		return rangeOf<std::uint64_t>(numbers, tuples, components);
	case grid::NumberType::float32:
		return rangeOf<float>(numbers, tuples, components);
	case grid::NumberType::float64:
		return rangeOf<double>(numbers, tuples, components);
	}
	return {};
}

} // namespace

std::size_t XmlArray::tuples() const
{
	if (!type)
		return static_cast<std::size_t>(std::ranges::count(bytes, std::byte{0}));
	return bytes.size() / (grid::byteSize(*type) * static_cast<std::size_t>(components));
}

XmlArray xmlTexts(std::string name, std::string_view texts)
{
	return {std::move(name), std::nullopt, 1, std::as_bytes(std::span(texts))};
}

void XmlArrays::add(XmlArray array)
{
	const auto same = std::ranges::find(arrays_, array.name, &XmlArray::name);
	if (same == arrays_.end())
		arrays_.push_back(std::move(array));
	else
		*same = std::move(array);
}

void XmlArrays::add(std::span<const Column> columns)
{
	UniqueNames names;
	for (const Column& column : columns)
		add(xmlArray(names.add(xmlText(column.name)), column.type, column.components, column.bytes));
}

std::optional<std::pair<double, double>> valueRange(const XmlArray& array)
{
	if (!array.type)
		return std::nullopt;
	const Range range =
	    rangeOf(*array.type, array.bytes.data(), array.tuples(), static_cast<std::size_t>(array.components));
	if (range.least > range.greatest)
		return std::nullopt;
	if (array.components > 1)
		return std::pair{std::sqrt(range.least), std::sqrt(range.greatest)};
	return std::pair{range.least, range.greatest};
}

} // namespace vp::write
