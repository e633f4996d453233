#include "text_values.h"

#include "base/real_text.h"
#include "vprobe-read/base/refusal.h"

#include <vtkDataArray.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace vp::reader::arrays
{

using grid::NumberType;

namespace
{

// Splits a text into words, one after the other.
class ValueWords
{
public:
	explicit ValueWords(std::string_view text) : rest_(text) {}
	std::optional<std::string_view> next()
	{
		constexpr std::string_view between = " \t\r\n\v\f,";
		const auto begin = rest_.find_first_not_of(between);
		if (begin == rest_.npos)
			return std::nullopt;
		const auto end = std::min(rest_.find_first_of(between, begin), rest_.size());
		const std::string_view word = rest_.substr(begin, end - begin);
		rest_.remove_prefix(end);
		return word;
	}

private:
	std::string_view rest_;
};

template <class Number>
Number numberOf(std::string_view word)
{
	if constexpr (std::is_integral_v<Number>) // exact with 64 bits
	{
		Number whole = 0;
		const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
		const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), whole);
		if (error == std::errc() && end == digits.data() + digits.size())
			return whole;
	}
	const std::optional<double> real = parseReal(word);
	if (!real)
		throw damaged("something else stands in place of a number");
	if constexpr (std::is_integral_v<Number>)
		if (!(*real >= static_cast<double>(std::numeric_limits<Number>::min())) ||
		    !(*real < std::ldexp(1.0, std::numeric_limits<Number>::digits)) || *real != std::floor(*real))
			throw damaged(fmt::format("its values are of a type that cannot hold {}", *real));
	return static_cast<Number>(*real);
}

template <class Number>
void parseValues(std::string_view text, std::uint64_t count, Number* to)
{
	ValueWords words(text);
	std::uint64_t at = 0;
	for (std::optional<std::string_view> word; (word = words.next()); ++at)
		if (at < count)
			*to++ = numberOf<Number>(*word);
	if (at != count)
		throw damaged(fmt::format("{} values where {} are wanted", at, count));
}

} // namespace

void parseText(std::string_view text, NumberType type, std::uint64_t count, void* to)
{
	const auto parse = [&](auto* values) { parseValues(text, count, values); };
	switch (type)
	{
	case NumberType::int8:
		return parse(static_cast<std::int8_t*>(to));
	case NumberType::uint8:
		return parse(static_cast<std::uint8_t*>(to));
	case NumberType::int16:
		return parse(static_cast<std::int16_t*>(to));
	case NumberType::uint16:
		return parse(static_cast<std::uint16_t*>(to));
	case NumberType::int32:
		return parse(static_cast<std::int32_t*>(to));
	case NumberType::uint32:
		return parse(static_cast<std::uint32_t*>(to));
	case NumberType::int64:
		return parse(static_cast<std::int64_t*>(to));
	case NumberType::uint64:
		return parse(static_cast<std::uint64_t*>(to));
	case NumberType::float32:
		return parse(static_cast<float*>(to));
	case NumberType::float64:
		return parse(static_cast<double*>(to));
	}
}

vtkSmartPointer<vtkDataArray> arrayOfText(std::string_view text, const ValueLayout& layout, std::uint64_t step,
                                          std::uint64_t steps, const std::string& name)
{
	std::uint64_t all = 0;
	if (__builtin_mul_overflow(layout.valueCount(), steps, &all) || all > text.size()) // each takes a character
		throw damaged(fmt::format("{} bytes of text where {} values at each of {} times are wanted", text.size(),
		                          layout.valueCount(), steps));
	const std::uint64_t bytes = layout.byteCount();
	std::string values(bytes * steps, '\0');
	parseText(text, layout.type, all, values.data());
	return arrayOf(std::string_view(values).substr(step * bytes, bytes),
	               {layout.points, layout.components, layout.type}, name);
}

} // namespace vp::reader::arrays
