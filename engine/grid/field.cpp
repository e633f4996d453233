#include "grid/field.h"

#include "base/parallel_reduce.h"
#include "grid/array_facts.h"
#include "grid/number_types.h"
#include "grid/shown_value.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

namespace vp::grid
{

namespace
{

template <class T>
constexpr NumberType numberTypeOf()
{
	if constexpr (std::is_same_v<T, float>)
		return NumberType::float32;
	else if constexpr (std::is_same_v<T, double>)
		return NumberType::float64;
	else
	{
		constexpr int base = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 2 : sizeof(T) == 4 ? 4 : 6;
		return static_cast<NumberType>(base + (std::is_unsigned_v<T> ? 1 : 0));
	}
}

bool isLower(char c)
{
	return c >= 'a' && c <= 'z';
}

bool isUpper(char c)
{
	return c >= 'A' && c <= 'Z';
}

// In lower case: GlobalNodeId, GLOBAL_NODE_ID and "global node id" are three words each.
std::vector<std::string> wordsOf(const std::string& name)
{
	std::vector<std::string> words(1);
	for (std::size_t i = 0; i < name.size(); ++i)
	{
		const char c = name[i];
		const bool starts = isUpper(c) && i > 0 && isLower(name[i - 1]);
		if (starts || (!isLower(c) && !isUpper(c)))
			words.emplace_back();
		if (isLower(c) || isUpper(c))
			words.back() += static_cast<char>(isUpper(c) ? c - 'A' + 'a' : c);
	}
	return words;
}

} // namespace

std::size_t byteSize(NumberType type)
{
	return withNumberType(type, [](auto number) { return sizeof(number); });
}

const char* numberTypeName(NumberType type)
{
	constexpr const char* names[] = {"int8",   "uint8", "int16",  "uint16",  "int32",
	                                 "uint32", "int64", "uint64", "float32", "float64"};
	return names[static_cast<int>(type)];
}

std::optional<NumberType> parseNumberType(std::string_view name)
{
	for (int type = 0; type <= static_cast<int>(NumberType::float64); ++type)
		if (name == numberTypeName(static_cast<NumberType>(type)))
			return static_cast<NumberType>(type);
	return std::nullopt;
}

const char* associationName(Association association)
{
	return association == Association::point ? "point" : "cell";
}

std::size_t Field::tuples() const
{
	if (stored)
		return stored->layout().itemCount();
	return components > 0 ? bytes.size() / (byteSize(type) * components) : 0;
}

const std::byte* Field::tuple(std::size_t number) const
{
	return stored ? stored->item(number) : bytes.data() + number * components * byteSize(type);
}

double Field::value(std::size_t tuple, int component) const
{
	if (stored) [[unlikely]]
		return withNumberType(type,
		                      [&](auto number) { return numberAt<decltype(number)>(stored->item(tuple), component); });
	const std::size_t index = tuple * components + component;
	return withNumberType(type, [&](auto number) { return numberAt<decltype(number)>(bytes.data(), index); });
}

Field inMemory(const Field& field)
{
	if (!field.stored)
		return field;
	Field read = field;
	std::vector<std::byte> bytes(field.stored->layout().byteCount());
	const std::size_t width = field.stored->layout().item_bytes;
	field.stored->forEachRun([&](std::uint64_t first, const std::byte* from, std::size_t count)
	                         { std::copy_n(from, count * width, bytes.data() + first * width); });
	read.stored.reset();
	read.bytes = std::move(bytes);
	return read;
}

bool namesCategories(const Field& field)
{
	constexpr std::array<std::string_view, 18> kWords{
	    "id",    "ids",      "material",   "materials", "label",        "labels",    "region", "regions", "zone",
	    "zones", "category", "categories", "segment",   "segmentation", "partition", "flag",   "flags",   "type"};
	if (field.type == NumberType::float32 || field.type == NumberType::float64)
		return false;
	const std::vector<std::string> words = wordsOf(field.name);
	return std::ranges::any_of(words, [&](const std::string& word) { return std::ranges::count(kWords, word) > 0; });
}

double loadNumber(NumberType type, const std::byte* at)
{
	return withNumberType(type, [&](auto number) { return numberAt<decltype(number)>(at, 0); });
}

void storeNumber(NumberType type, double value, std::byte* at)
{
	withNumberType(type, [&](auto number) { storeAs<decltype(number)>(value, at); });
}

template <class T>
Field makeField(std::string name, Association association, int components, std::vector<T> values)
{
	auto owned = std::make_shared<const std::vector<T>>(std::move(values));
	const auto* bytes = reinterpret_cast<const std::byte*>(owned->data());
	const std::size_t size = owned->size() * sizeof(T);
	return {std::move(name),
	        association,
	        components,
	        numberTypeOf<T>(),
	        Array<std::byte>(std::move(owned), bytes, size),
	        false};
}

template Field makeField(std::string, Association, int, std::vector<std::int8_t>);
template Field makeField(std::string, Association, int, std::vector<std::uint8_t>);
template Field makeField(std::string, Association, int, std::vector<std::int16_t>);
template Field makeField(std::string, Association, int, std::vector<std::uint16_t>);
template Field makeField(std::string, Association, int, std::vector<std::int32_t>);
template Field makeField(std::string, Association, int, std::vector<std::uint32_t>);
template Field makeField(std::string, Association, int, std::vector<std::int64_t>);
template Field makeField(std::string, Association, int, std::vector<std::uint64_t>);
template Field makeField(std::string, Association, int, std::vector<float>);
template Field makeField(std::string, Association, int, std::vector<double>);

void ValueSpan::include(double value)
{
	if (std::isfinite(value))
	{
		lo = std::min(lo, value);
		hi = std::max(hi, value);
	}
	else if (!std::isnan(value))
		(value > 0.0 ? plus_infinity : minus_infinity) = true;
}

void ValueSpan::include(const ValueSpan& other)
{
	lo = std::min(lo, other.lo);
	hi = std::max(hi, other.hi);
	minus_infinity = minus_infinity || other.minus_infinity;
	plus_infinity = plus_infinity || other.plus_infinity;
}

namespace
{

// Returns the span of tuples that lie one after the other.
template <class T>
ValueSpan spanOfRun(const std::byte* bytes, std::size_t count, int components, int component, ValueSpan result)
{
	const std::size_t width = components;
	for (std::size_t t = 0; t < count; ++t)
	{
		if (component != kMagnitude)
		{
			result.include(numberAt<T>(bytes, t * width + component));
			continue;
		}
		double square = 0.0;
		for (std::size_t c = 0; c < width; ++c)
		{
			const double value = numberAt<T>(bytes, t * width + c);
			square += magnitudeWeight(components, static_cast<int>(c)) * value * value;
		}
		result.include(std::sqrt(square));
	}
	return result;
}

// The sign of a zero may be that of any of them.
template <class T>
ValueSpan spanOfStored(const Field& field, int component)
{
	tbb::enumerable_thread_specific<ValueSpan> spans;
	field.stored->forEachRun(
	    [&](std::uint64_t, const std::byte* bytes, std::size_t count)
	    { spans.local() = spanOfRun<T>(bytes, count, field.components, component, spans.local()); });
	return spans.combine(
	    [](ValueSpan a, const ValueSpan& b)
	    {
		    a.include(b);
		    return a;
	    });
}

} // namespace

ValueSpan valueSpan(const Field& field, int component)
{
	if (field.facts)
		return field.facts->spans[static_cast<std::size_t>(component == kMagnitude ? field.components : component)];
	const auto range = [&](auto number)
	{
		using T = decltype(number);
		if (field.stored)
			return spanOfStored<T>(field, component);
		const std::size_t width = field.components * sizeof(T);
		const auto scan = [&](const tbb::blocked_range<std::size_t>& tuples, ValueSpan result)
		{
			return spanOfRun<T>(field.bytes.data() + tuples.begin() * width, tuples.size(), field.components, component,
			                    result);
		};
		const auto join = [](ValueSpan a, const ValueSpan& b)
		{
			a.include(b);
			return a;
		};
		return parallelReduce(field.tuples(), 65536, ValueSpan{}, scan, join);
	};
	return withNumberType(field.type, range);
}

std::pair<double, double> fieldRange(const Field& field, int component)
{
	return valueSpan(field, component).range();
}

} // namespace vp::grid
