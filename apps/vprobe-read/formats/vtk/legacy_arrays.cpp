#include "legacy_arrays.h"

#include "base/real_text.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/text_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

namespace vp::reader::vtk
{

using grid::NumberType;

namespace
{

struct LegacyType
{
	std::string_view word;
	NumberType type;
};

// VTK writes and reads its vtkIdType as 32 bits here.
constexpr LegacyType kLegacyTypes[] = {
    {"char", NumberType::int8},          {"signed_char", NumberType::int8},      {"unsigned_char", NumberType::uint8},
    {"short", NumberType::int16},        {"unsigned_short", NumberType::uint16}, {"int", NumberType::int32},
    {"vtkidtype", NumberType::int32},    {"unsigned_int", NumberType::uint32},   {"long", NumberType::int64},
    {"vtktypeint64", NumberType::int64}, {"unsigned_long", NumberType::uint64},  {"vtktypeuint64", NumberType::uint64},
    {"float", NumberType::float32},      {"double", NumberType::float64}};

// Returns nothing for bits and texts.
std::optional<NumberType> numberTypeOf(const std::string& type)
{
	const auto known = std::find_if(std::begin(kLegacyTypes), std::end(kLegacyTypes),
	                                [&](const LegacyType& each) { return each.word == type; });
	return known == std::end(kLegacyTypes) ? std::nullopt : std::optional(known->type);
}

std::string bigEndian(std::uint64_t value, std::size_t bytes)
{
	std::array<char, sizeof value> all;
	putNumber(value, all.data(), ByteOrder::big);
	return {all.data() + all.size() - bytes, bytes};
}

// How binary files write a text: the first two bits say how long its length is.
std::string lengthOfText(std::size_t length)
{
	if (length < std::size_t(1) << 6)
		return bigEndian(length | 0xC0, 1);
	if (length < std::size_t(1) << 14)
		return bigEndian(length | 0x8000, 2);
	if (length < std::size_t(1) << 30)
		return bigEndian(length | 0x40000000, 4);
	return bigEndian(length, 8);
}

void checkLegacyCount(std::uint64_t there, std::uint64_t wanted, const std::string& words)
{
	if (there != wanted)
		throw damaged(fmt::format("{} has {} values where {} belong", words, there, wanted));
}

} // namespace

std::string inSmallLetters(std::string_view word)
{
	std::string small(word);
	std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
	return small;
}

std::string decodedText(std::string_view text)
{
	std::string decoded;
	for (std::size_t i = 0; i < text.size(); ++i)
	{
		unsigned value = 0;
		const char* digits = text.data() + i + 1;
		if (text[i] == '%' && i + 2 < text.size() && std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2)
		{
			decoded += static_cast<char>(value);
			i += 2;
		}
		else
			decoded += text[i];
	}
	return decoded;
}

void LegacyArrays::write(std::string_view bytes)
{
	if (to_)
		to_->append(bytes);
}

std::uint64_t LegacyArrays::countOf()
{
	const std::int64_t count = at_.integer();
	if (count < 0 || count > std::int64_t(1) << 40)
		throw damaged(fmt::format("a number of {}", count));
	return static_cast<std::uint64_t>(count);
}

void LegacyArrays::copyReals(const std::string& word, std::size_t count)
{
	std::string line = word;
	for (std::size_t i = 0; i < count; ++i)
	{
		const std::string_view digits = at_.word();
		const std::optional<double> number = parseReal(digits);
		if (!number || !std::isfinite(*number))
			throw damaged(fmt::format("\"{}\" in its {} is no finite number", digits.substr(0, 40), word));
		double known = 0.0;
		const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), known);
		is_changed_ |= error != std::errc() || end != digits.data() + digits.size();
		line += fmt::format(" {}", *number);
	}
	write(line + "\n");
}

void LegacyArrays::copyShades(std::uint64_t count, const std::string& words)
{
	last_ = words;
	if (!is_text_)
		return void(copyNumbers(NumberType::uint8, count, words));
	std::string shades;
	for (std::uint64_t i = 0; i < count; ++i)
	{
		const double share = at_.real();
		if (!(share >= 0.0 && share <= 1.0))
			throw damaged(fmt::format("{} has a color {} that is no share of 1", words, share));
		shades += static_cast<char>(static_cast<unsigned char>(255.0 * share + 0.5));
	}
	write(shades + "\n");
}

std::int64_t LegacyArrays::copyArray(const std::string& type, std::uint64_t values, const std::string& words)
{
	if (type == "bit")
		copyBits(values, words);
	else if (type == "string" || type == "utf8_string")
		copyTexts(values, words);
	else if (const std::optional<NumberType> known = numberTypeOf(type))
		return copyNumbers(*known, values, words);
	else
		throw NotCopied();
	return 0;
}

std::int64_t LegacyArrays::copyNumbers(NumberType type, std::uint64_t values, const std::string& words)
{
	last_ = words;
	if (values == 0)
		return 0;
	if (is_text_)
	{
		const text::Numbers numbers = text::readNumbers(text_.substr(at_.place()), type, words,
		                                                {.to = to_, .order = ByteOrder::big, .most = values});
		checkLegacyCount(numbers.count, values, words);
		at_.moveTo(at_.place() + numbers.behind);
		write("\n");
		return numbers.last;
	}
	const std::string_view bytes = takeBytes(values, byteSize(type), words);
	if (type != NumberType::int32 && type != NumberType::int64)
		return 0;
	const char* last = bytes.data() + bytes.size() - byteSize(type);
	return type == NumberType::int32 ? numberAt<std::int32_t>(last, ByteOrder::big)
	                                 : numberAt<std::int64_t>(last, ByteOrder::big);
}

void LegacyArrays::notePlain(std::optional<bool> on_points, const std::string& name, const std::string& type,
                             std::uint64_t tuples, std::uint64_t components)
{
	const std::optional<NumberType> number = numberTypeOf(type);
	if (is_text_ || !on_points || !number)
		return;
	const std::uint64_t begin = at_.place() - tuples * components * byteSize(*number);
	plain_.push_back({*on_points, decodedText(name), *number, components, {begin}, byteSize(*number) > 1});
}

// Those of a binary file, which begin behind the line.
std::string_view LegacyArrays::takeBytes(std::uint64_t values, std::uint64_t each, const std::string& words)
{
	endLine();
	const std::uint64_t there = (text_.size() - at_.place()) / each;
	if (there < values)
		checkLegacyCount(there, values, words);
	const std::string_view bytes = text_.substr(at_.place(), values * each);
	at_.moveTo(at_.place() + bytes.size());
	write(bytes);
	write("\n");
	return bytes;
}

void LegacyArrays::endLine()
{
	at_.moveTo(std::min(text_.find('\n', at_.place()), text_.size() - 1) + 1);
}

void LegacyArrays::copyBits(std::uint64_t values, const std::string& words)
{
	last_ = words;
	if (values == 0)
		return;
	if (!is_text_)
		return void(takeBytes((values + 7) / 8, 1, words));
	std::string bytes((at_.checkedCount(static_cast<std::int64_t>(values), 2) + 7) / 8, '\0');
	for (std::uint64_t i = 0; i < values; ++i)
		if (at_.integer() != 0)
			bytes[i / 8] = static_cast<char>(bytes[i / 8] | 0x80 >> i % 8);
	write(bytes + "\n");
}

void LegacyArrays::copyTexts(std::uint64_t values, const std::string& words)
{
	last_ = words;
	endLine();
	for (std::uint64_t i = 0; i < values; ++i)
		if (is_text_)
		{
			const std::string text = decodedText(at_.line());
			write(lengthOfText(text.size()) + text);
		}
		else
			copyText(words);
	write("\n");
}

void LegacyArrays::copyText(const std::string& words)
{
	const std::string_view rest = text_.substr(at_.place());
	if (rest.empty())
		at_.endsEarly();
	constexpr std::size_t kBytes[] = {8, 4, 2, 1};
	const std::size_t bytes = kBytes[static_cast<unsigned char>(rest[0]) >> 6];
	std::uint64_t length = integerAt(rest.data(), std::min(bytes, rest.size()), ByteOrder::big);
	length &= bytes == 8 ? ~std::uint64_t(0) : (std::uint64_t(1) << (8 * bytes - 2)) - 1;
	if (rest.size() < bytes || length > rest.size() - bytes)
		throw damaged(fmt::format("{} ends too early", words));
	write(rest.substr(0, bytes + length));
	at_.moveTo(at_.place() + bytes + length);
}

} // namespace vp::reader::vtk
