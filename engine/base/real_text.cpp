#include "base/real_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>

namespace vp
{

namespace
{

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool isDigit(char c)
{
	return c >= '0' && c <= '9';
}

char small(char c)
{
	return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// `words` are in small letters.
bool begins(std::string_view text, std::string_view words)
{
	return text.size() >= words.size() &&
	       std::equal(words.begin(), words.end(), text.begin(), [](char word, char c) { return word == small(c); });
}

bool is(std::string_view text, std::string_view words)
{
	return text.size() == words.size() && begins(text, words);
}

std::optional<double> parseSpecial(std::string_view text)
{
	if (is(text, "inf") || is(text, "infinity"))
		return kInfinity;
	if (is(text, "nan") || is(text, "nanq") || is(text, "nans") || (begins(text, "nan(") && text.back() == ')'))
		return kNan;
	if (!begins(text, "1.#"))
		return std::nullopt;
	text.remove_prefix(3);
	while (!text.empty() && text.back() == '0') // it fills up the digits that were asked for
		text.remove_suffix(1);
	if (is(text, "inf"))
		return kInfinity;
	if (is(text, "qnan") || is(text, "snan") || is(text, "ind"))
		return kNan;
	return std::nullopt;
}

// The number as C writes it: an "e" before the exponent. Empty if it is like that already.
std::string withoutFortran(std::string_view text)
{
	for (std::size_t at = 1; at < text.size(); ++at)
	{
		const char letter = small(text[at]);
		if (letter == 'e')
			return {};
		std::string written(text);
		if (letter == 'd' || letter == 'q')
		{
			written[at] = 'e';
			return written;
		}
		if (letter == '+' || letter == '-')
			return written.insert(at, 1, 'e');
	}
	return {};
}

std::optional<double> parseDigits(std::string_view text)
{
	double value = 0.0;
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
	if (end != text.data() + text.size() || error == std::errc::invalid_argument)
		return std::nullopt;
	if (error != std::errc::result_out_of_range)
		return value;
	// Digits that are not 0 before the point, without an exponent below 0, are too many; all else is too small.
	const std::size_t exponent = std::min(text.find_first_of("eE"), text.size());
	const bool is_small = exponent + 1 < text.size() ? text[exponent + 1] == '-' : text[0] == '0' || text[0] == '.';
	return is_small ? 0.0 : kInfinity;
}

} // namespace

std::optional<double> parseReal(std::string_view word)
{
	const bool is_negative = !word.empty() && word[0] == '-';
	if (is_negative || (!word.empty() && word[0] == '+'))
		word.remove_prefix(1);
	if (word.empty())
		return std::nullopt;
	std::optional<double> value;
	if (!isDigit(word[0]) && word[0] != '.')
		value = parseSpecial(word);
	else if (value = parseDigits(word); !value)
	{
		if (const std::string written = withoutFortran(word); !written.empty())
			value = parseDigits(written);
		if (!value)
			value = parseSpecial(word);
	}
	if (value && is_negative)
		value = -*value;
	return value;
}

} // namespace vp
