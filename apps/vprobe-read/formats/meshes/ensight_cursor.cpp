#include "ensight_cursor.h"

#include "base/real_text.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <filesystem>
#include <limits>
#include <optional>
#include <sstream>

namespace vp::reader::meshes
{

namespace
{

constexpr std::size_t kLineBytes = 80; // the length of a line in a binary file
constexpr std::size_t kMaxShown = 20;  // letters of a word that is wrong
constexpr std::string_view kBegin = "BEGIN TIME STEP";
constexpr std::string_view kEnd = "END TIME STEP";

bool isWhite(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r');
}

std::string_view withoutSpace(std::string_view text)
{
	while (!text.empty() && (isWhite(text.front())))
		text.remove_prefix(1);
	while (!text.empty() && (isWhite(text.back())))
		text.remove_suffix(1);
	return text;
}

std::uint32_t fortranMark(std::string_view bytes, std::size_t at, bool swaps)
{
	return numberAt<std::uint32_t>(bytes.data() + at, byteOrder(swaps));
}

// The contents of Fortran's records without the lengths around them. A length below 0 is that of a part of a record.
std::string joinRecords(std::string_view bytes, const std::string& name)
{
	std::string joined;
	joined.reserve(bytes.size());
	const bool swaps = bytes.size() >= 4 && fortranMark(bytes, 0, false) != kLineBytes;
	for (std::size_t at = 0; at < bytes.size();)
	{
		const auto lengthAt = [&](std::size_t place) -> std::size_t
		{
			if (bytes.size() - place < 4)
				throw damaged(fmt::format("{} ends early", name));
			const auto mark = static_cast<std::int32_t>(fortranMark(bytes, place, swaps));
			return static_cast<std::size_t>(std::abs(static_cast<std::int64_t>(mark)));
		};
		const std::size_t length = lengthAt(at);
		if (bytes.size() - at < length + 8)
			throw damaged(fmt::format("{} ends early", name));
		if (lengthAt(at + 4 + length) != length)
			throw damaged(fmt::format("the lengths around a record of {} differ", name));
		joined.append(bytes.substr(at + 4, length));
		at += length + 8;
	}
	return joined;
}

// Where the line `mark` begins, from `at` on; in a binary file it fills a line.
std::size_t findMark(std::string_view bytes, std::string_view mark, std::size_t at, bool binary)
{
	for (at = bytes.find(mark, at); at != bytes.npos; at = bytes.find(mark, at + 1))
	{
		std::string_view rest = bytes.substr(at + mark.size());
		if (!binary)
		{
			std::size_t start = at;
			while (start > 0 && (bytes[start - 1] == ' ' || bytes[start - 1] == '\t'))
				--start;
			rest = rest.substr(0, rest.find('\n'));
			if ((start == 0 || bytes[start - 1] == '\n') && withoutSpace(rest).empty())
				return at;
		}
		else if (rest.size() >= kLineBytes - mark.size() && (rest[0] == '\0' || rest[0] == ' '))
			return at;
	}
	return bytes.npos;
}

} // namespace

std::vector<std::string> wordsOf(std::string_view line)
{
	std::istringstream in{std::string(line)};
	std::vector<std::string> words;
	for (std::string word; in >> word;)
		words.push_back(word);
	return words;
}

std::string ensightWords(std::string_view text)
{
	std::string words(text.substr(0, kMaxShown));
	for (char& c : words)
		if (c < ' ' || c > '~')
			c = '?';
	return words;
}

EnSightFile::EnSightFile(const std::string& file)
{
	open(file);
	const std::string_view text = mapped_->text();
	const std::string_view head = text.substr(0, kLineBytes + 4);
	if (head.starts_with("C Binary") || head.starts_with("C binary"))
		form_ = Form::c_binary;
	else if (head.size() > 4 &&
	         (head.substr(4).starts_with("Fortran Binary") || head.substr(4).starts_with("Fortran binary")))
	{
		form_ = Form::fortran;
		joined_ = joinRecords(text, name_);
	}
	if (form_ != Form::text && bytes().size() < kLineBytes)
		throw damaged(fmt::format("{} ends early", name_));
}

EnSightFile::EnSightFile(const std::string& file, Form form) : form_(form)
{
	open(file);
	if (form == Form::fortran)
		joined_ = joinRecords(mapped_->text(), name_);
}

void EnSightFile::open(const std::string& file)
{
	name_ = std::filesystem::path(file).filename().string();
	std::error_code none;
	if (!std::filesystem::is_regular_file(file, none))
		throw Refusal(fmt::format("its file {} cannot be opened; keep them together", name_));
	mapped_ = std::make_unique<MappedText>(file);
}

std::string_view EnSightFile::step(std::size_t number, bool& is_step) const
{
	const std::string_view all = bytes();
	const bool binary = form_ != Form::text;
	const auto bodyAt = [&](std::size_t mark)
	{ return binary ? mark + kLineBytes : std::min(all.find('\n', mark), all.size() - 1) + 1; };
	std::size_t begin = findMark(all, kBegin, 0, binary);
	is_step = begin != all.npos;
	if (!is_step)
		return all;
	for (std::size_t i = 0;; ++i)
	{
		const std::size_t end = findMark(all, kEnd, bodyAt(begin), binary);
		if (end == all.npos)
			throw damaged(fmt::format("{} ends early", name_));
		if (i == number)
			return all.substr(bodyAt(begin), end - bodyAt(begin));
		begin = findMark(all, kBegin, bodyAt(end), binary);
		if (begin == all.npos)
			throw damaged(fmt::format("{} holds {} steps, fewer than its time set", name_, i + 1));
	}
}

EnSightCursor::EnSightCursor(const EnSightFile& file, std::string_view step)
    : name_(file.name()), bytes_(step), binary_(file.form() != EnSightFile::Form::text)
{
	if (binary_ && (bytes_.starts_with("C Binary") || bytes_.starts_with("C binary") ||
	                bytes_.starts_with("Fortran Binary") || bytes_.starts_with("Fortran binary")))
		at_ = std::min(kLineBytes, bytes_.size());
}

void EnSightCursor::refuse(const std::string& reason) const
{
	throw damaged(fmt::format("{}: {}", name_, reason));
}

void EnSightCursor::endsEarly() const
{
	throw damaged(fmt::format("{} ends early", name_));
}

// Lines that begin with # are comments.
void EnSightCursor::skipSpace()
{
	while (at_ < bytes_.size())
		if (isWhite(bytes_[at_]))
			++at_;
		else if (bytes_[at_] == '#' && (at_ == 0 || bytes_[at_ - 1] == '\n'))
			at_ = std::min(bytes_.find('\n', at_), bytes_.size());
		else
			return;
}

bool EnSightCursor::atEnd()
{
	if (!binary_)
		skipSpace();
	return at_ >= bytes_.size();
}

std::string EnSightCursor::line()
{
	if (atEnd())
		return {};
	return std::string(withoutSpace(description()));
}

std::string EnSightCursor::description()
{
	if (at_ >= bytes_.size() || (binary_ && bytes_.size() - at_ < kLineBytes))
		endsEarly();
	const std::size_t end = binary_ ? at_ + kLineBytes : std::min(bytes_.find('\n', at_), bytes_.size());
	std::string_view line = bytes_.substr(at_, end - at_);
	at_ = binary_ ? end : std::min(end + 1, bytes_.size());
	if (binary_)
		line = line.substr(0, line.find('\0'));
	return std::string(line);
}

void EnSightCursor::setSwaps(bool swaps)
{
	swaps_ = swaps;
	knows_order_ = true;
}

std::uint32_t EnSightCursor::word()
{
	if (bytes_.size() - at_ < 4)
		endsEarly();
	at_ += 4;
	return numberAt<std::uint32_t>(bytes_.data() + at_ - 4, byteOrder(swaps_));
}

std::int64_t EnSightCursor::integer()
{
	if (binary_)
	{
		std::uint32_t value = word();
		if (!knows_order_ && value != __builtin_bswap32(value))
		{
			setSwaps(__builtin_bswap32(value) < value);
			if (swaps_)
				value = __builtin_bswap32(value);
		}
		return static_cast<std::int32_t>(value);
	}
	if (atEnd())
		endsEarly();
	const std::size_t start = at_;
	while (at_ < bytes_.size() && !isWhite(bytes_[at_]))
		++at_;
	std::string_view digits = bytes_.substr(start, at_ - start);
	if (digits.size() > 1 && digits[0] == '+')
		digits.remove_prefix(1);
	std::int64_t value = 0;
	const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
	if (error != std::errc() || end != digits.data() + digits.size())
		refuse(fmt::format("\"{}\" where a whole number is wanted", ensightWords(digits)));
	return value;
}

void EnSightCursor::needRoom(std::int64_t things, std::int64_t numbers_of_each) const
{
	const std::size_t least_bytes = static_cast<std::size_t>(numbers_of_each) * (binary_ ? 4 : 2);
	const std::size_t room = bytes_.size() - std::min(at_, bytes_.size()) + 1;
	if (things < 0)
		refuse(fmt::format("it announces {} of something", things));
	if (things > 0 && least_bytes > 0 && static_cast<std::uint64_t>(things) > room / least_bytes)
		endsEarly();
}

std::int64_t EnSightCursor::count(std::int64_t numbers_of_each)
{
	const std::int64_t things = integer();
	needRoom(things, numbers_of_each);
	return things;
}

std::vector<std::int64_t> EnSightCursor::integers(std::int64_t count)
{
	needRoom(count, 1);
	std::vector<std::int64_t> values(static_cast<std::size_t>(count));
	for (std::int64_t& value : values)
		value = integer();
	return values;
}

// Columns of fixed width may touch: a number ends at a sign that does not begin its exponent.
double EnSightCursor::textReal()
{
	if (atEnd())
		endsEarly();
	std::size_t end = at_;
	while (end < bytes_.size() && !isWhite(bytes_[end]))
		++end;
	const std::string_view all = bytes_.substr(at_, end - at_);
	if (const std::optional<double> value = parseReal(all))
	{
		at_ = end;
		return *value;
	}
	bool has_exponent = false;
	std::size_t length = 1;
	for (; length < all.size(); ++length)
	{
		const bool is_letter = std::string_view("eEdD").find(all[length]) != std::string_view::npos;
		const bool is_sign = all[length] == '-' || all[length] == '+';
		if (is_sign && has_exponent)
			break;
		if (is_letter || is_sign)
			has_exponent = true;
		if (is_letter && length + 1 < all.size() && (all[length + 1] == '-' || all[length + 1] == '+'))
			++length;
	}
	const std::optional<double> value = parseReal(all.substr(0, length));
	if (!value)
		refuse(fmt::format("\"{}\" where a number is wanted", ensightWords(all)));
	at_ += length;
	return *value;
}

void EnSightCursor::reals(double* to, std::int64_t count, std::size_t stride)
{
	needRoom(count, 1);
	for (std::int64_t i = 0; i < count; ++i, to += stride)
		*to = binary_ ? static_cast<double>(std::bit_cast<float>(word())) : textReal();
}

std::vector<double> EnSightCursor::reals(std::int64_t count)
{
	needRoom(count, 1);
	std::vector<double> values(static_cast<std::size_t>(count));
	reals(values.data(), count);
	return values;
}

void EnSightCursor::skip(std::int64_t numbers)
{
	needRoom(numbers, 1);
	if (!binary_)
		for (; numbers > 0; --numbers)
			textReal();
	else if (static_cast<std::size_t>(numbers) * 4 > bytes_.size() - at_)
		endsEarly();
	else
		at_ += static_cast<std::size_t>(numbers) * 4;
}

} // namespace vp::reader::meshes
