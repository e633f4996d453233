#include "ensight_cursor.h"

#include "refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>

namespace
{
// Sums stop here, short of overflow.
constexpr std::int64_t kMoreThanAny = std::int64_t(1) << 60;
} // namespace

Words wordsOf(const std::string& line)
{
	std::istringstream in(line);
	Words words;
	for (std::string word; in >> word;)
		words.push_back(word);
	return words;
}

EnSightCursor::EnSightCursor(const std::string& file, bool binary)
    : name_(std::filesystem::path(file).filename().string()), in_(file, std::ios::binary), binary_(binary)
{
	std::error_code none;
	size_ = std::filesystem::file_size(file, none);
	if (!in_ || none)
		throw Refusal(fmt::format("its file {} cannot be opened; keep them together", name_));
}

EnSightCursor EnSightCursor::ofGeometry(const std::string& file)
{
	EnSightCursor cursor(file, false);
	std::array<char, 80> head = {};
	cursor.in_.read(head.data(), head.size());
	const std::string_view text(head.data(), head.size());
	cursor.binary_ = text.starts_with("C Binary");
	if (text.starts_with("Fortran Binary"))
		throw NotUnderstood();
	cursor.in_.clear();
	cursor.in_.seekg(cursor.binary_ ? 80 : 0);
	return cursor;
}

std::string EnSightCursor::line()
{
	std::string text;
	if (binary_)
	{
		const std::uint64_t left = size_ - std::min<std::uint64_t>(size_, static_cast<std::uint64_t>(in_.tellg()));
		if (left == 0)
			return {};
		text.resize(80);
		if (left < 80 || !in_.read(text.data(), 80))
			endsEarly();
		return text.substr(0, std::min(text.find('\0'), text.size()));
	}
	while (std::getline(in_, text))
		if (const auto start = text.find_first_not_of(" \t\r"); start != text.npos && text[start] != '#')
			return text;
	return {};
}

std::int64_t EnSightCursor::integer()
{
	if (!binary_)
	{
		const Words words = wordsOf(line());
		if (words.empty())
			endsEarly();
		return std::atoll(words[0].c_str());
	}
	std::uint32_t value = 0;
	if (!in_.read(reinterpret_cast<char*>(&value), 4))
		endsEarly();
	// Either byte order; counts are smaller than the file.
	return value <= size_ ? value : __builtin_bswap32(value);
}

std::int64_t EnSightCursor::count()
{
	const std::int64_t value = integer();
	if (value < 0 || static_cast<std::uint64_t>(value) > size_)
		endsEarly();
	return value;
}

std::int64_t EnSightCursor::product(std::int64_t a, std::int64_t b) const
{
	std::int64_t product = 0;
	if (__builtin_mul_overflow(a, b, &product))
		endsEarly();
	return product;
}

void EnSightCursor::skip(std::int64_t numbers, std::int64_t lines)
{
	if (numbers < 0 || lines < 0 || static_cast<std::uint64_t>(numbers) > size_)
		endsEarly();
	if (binary_)
	{
		in_.seekg(numbers * 4, std::ios::cur);
		if (!in_ || static_cast<std::uint64_t>(in_.tellg()) > size_)
			endsEarly();
		return;
	}
	for (; lines > 0; --lines)
		if (line().empty())
			endsEarly();
}

std::int64_t EnSightCursor::sumOf(std::int64_t numbers)
{
	std::int64_t sum = 0;
	for (std::int64_t i = 0; i < numbers; ++i)
		sum = std::min(sum + count(), kMoreThanAny);
	return sum;
}

void EnSightCursor::endsEarly() const
{
	throw damaged(fmt::format("{} ends early", name_));
}
