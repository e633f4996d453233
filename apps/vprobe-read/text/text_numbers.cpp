#include "text_numbers.h"

#include "base/real_text.h"
#include "parts/part_bytes.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace vp::reader::text
{

using grid::NumberType;

namespace
{

constexpr std::size_t kBatch = 1 << 15;

bool isBlankLetter(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r');
}

template <class T>
class NumberReader
{
public:
	NumberReader(const std::string& array, const NumberTarget& target) : array_(array), target_(target)
	{
		values_.reserve(kBatch);
	}

	Numbers read(std::string_view text)
	{
		const char* at = text.data();
		const char* const end = at + text.size();
		while (found_.count < target_.most)
		{
			while (at != end && isBlankLetter(*at))
				++at;
			if (at == end)
				break;
			if (target_.is_xml && *at == '<')
			{
				const std::size_t length = lengthOfMarkup(std::string_view(at, static_cast<std::size_t>(end - at)));
				if (length == 0)
					throw damaged(fmt::format("{} has tags among its numbers", array_));
				at += length;
			}
			else
				at = take(at, end);
		}
		flush();
		found_.behind = static_cast<std::uint64_t>(at - text.data());
		return found_;
	}

private:
	const char* take(const char* at, const char* end)
	{
		T value = {};
		auto [next, error] = std::from_chars(at, end, value);
		const bool is_plain = error == std::errc() && (next == end || endsWord(*next));
		if (!is_plain)
		{
			next = std::find_if(at, end, [this](char c) { return endsWord(c); });
			value = toNumber(std::string_view(at, static_cast<std::size_t>(next - at)));
		}
		if constexpr (std::is_floating_point_v<T>)
			found_.is_strange |= !is_plain || !std::isfinite(value);
		else
		{
			found_.is_strange |= !is_plain;
			found_.last = static_cast<std::int64_t>(value);
		}
		++found_.count;
		values_.push_back(value);
		if (values_.size() == kBatch)
			flush();
		return next;
	}

	bool endsWord(char c) const { return isBlankLetter(c) || (c == '<' && target_.is_xml); }

	T toNumber(std::string_view word) const
	{
		const std::optional<double> value = parseReal(word);
		if (!value)
			throw damaged(fmt::format("\"{}\" in {} is no number", word.substr(0, 40), array_));
		if constexpr (std::is_floating_point_v<T>)
		{
			if (std::isfinite(*value) && std::abs(*value) > static_cast<double>(std::numeric_limits<T>::max()))
				throw Refusal(fmt::format("\"{}\" in {} is too large for its type; give the array a type of 64 bits",
				                          word.substr(0, 40), array_));
		}
		else
		{
			constexpr double kLow = static_cast<double>(std::numeric_limits<T>::min());
			constexpr double kHigh = static_cast<double>(std::numeric_limits<T>::max() / 2 + 1) * 2.0; // one more
			if (!(*value >= kLow && *value < kHigh) || *value != std::floor(*value))
				throw Refusal(fmt::format("\"{}\" in {} is no value of its type; give the array another type",
				                          word.substr(0, 40), array_));
		}
		return static_cast<T>(*value);
	}

	void flush()
	{
		if (target_.to && !values_.empty())
		{
			const auto bytes = std::as_writable_bytes(std::span(values_));
			if (target_.order == ByteOrder::big)
				parts::swapNumbers(bytes, sizeof(T));
			target_.to->append({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
		}
		values_.clear();
	}

	const std::string& array_;
	const NumberTarget& target_;
	std::vector<T> values_;
	Numbers found_;
};

} // namespace

Numbers readNumbers(std::string_view text, NumberType type, const std::string& array, const NumberTarget& target)
{
	switch (type)
	{
	case NumberType::int8:
		return NumberReader<std::int8_t>(array, target).read(text);
	case NumberType::uint8:
		return NumberReader<std::uint8_t>(array, target).read(text);
	case NumberType::int16:
		return NumberReader<std::int16_t>(array, target).read(text);
	case NumberType::uint16:
		return NumberReader<std::uint16_t>(array, target).read(text);
	case NumberType::int32:
		return NumberReader<std::int32_t>(array, target).read(text);
	case NumberType::uint32:
		return NumberReader<std::uint32_t>(array, target).read(text);
	case NumberType::int64:
		return NumberReader<std::int64_t>(array, target).read(text);
	case NumberType::uint64:
		return NumberReader<std::uint64_t>(array, target).read(text);
	case NumberType::float32:
		return NumberReader<float>(array, target).read(text);
	default:
		return NumberReader<double>(array, target).read(text);
	}
}

std::size_t lengthOfMarkup(std::string_view text)
{
	const bool is_comment = text.starts_with("<!--");
	std::string closing = is_comment ? "-->" : ">";
	if (!is_comment && text.size() > 1 && text[1] != '/' && text[1] != '?' && text[1] != '!')
	{
		const std::size_t tag = text.find('>');
		if (tag != text.npos && text[tag - 1] != '/')
			closing = fmt::format("</{}>", text.substr(1, text.find_first_of(" \t\r\n/>") - 1));
	}
	const std::size_t found = text.find(closing);
	return text.starts_with("<![") || found == text.npos ? 0 : found + closing.size();
}

} // namespace vp::reader::text
