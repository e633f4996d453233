#include "text_cursor.h"

#include "base/real_text.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace vp::reader::text
{

namespace
{

bool isSpace(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r');
}

std::string_view withoutSpace(std::string_view line)
{
	while (!line.empty() && isSpace(line.front()))
		line.remove_prefix(1);
	while (!line.empty() && isSpace(line.back()))
		line.remove_suffix(1);
	return line;
}

} // namespace

void Cursor::endsEarly() const
{
	throw damaged("it ends before all that it announces");
}

void Cursor::skipSpace()
{
	while (at_ < text_.size() && isSpace(text_[at_]))
		++at_;
}

bool Cursor::atEnd()
{
	skipSpace();
	return at_ >= text_.size();
}

std::string_view Cursor::line()
{
	if (at_ >= text_.size())
		endsEarly();
	const std::size_t end = std::min(text_.find('\n', at_), text_.size());
	const std::string_view line = withoutSpace(text_.substr(at_, end - at_));
	at_ = std::min(end + 1, text_.size());
	return line;
}

std::string_view Cursor::peekLine()
{
	if (atEnd())
		return {};
	return withoutSpace(text_.substr(at_, text_.find('\n', at_) - at_));
}

std::string_view Cursor::word()
{
	skipSpace();
	const std::size_t start = at_;
	while (at_ < text_.size() && !isSpace(text_[at_]))
		++at_;
	if (at_ == start)
		endsEarly();
	return text_.substr(start, at_ - start);
}

std::int64_t Cursor::integer()
{
	std::string_view digits = word();
	if (digits.size() > 1 && digits[0] == '+')
		digits.remove_prefix(1);
	std::int64_t value = 0;
	const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
	if (error != std::errc() || end != digits.data() + digits.size())
		throw damaged(fmt::format("\"{}\" where a whole number is wanted", digits.substr(0, 20)));
	return value;
}

double Cursor::real()
{
	const std::string_view digits = word();
	if (const std::optional<double> value = parseReal(digits))
		return *value;
	throw damaged(fmt::format("\"{}\" where a number is wanted", digits.substr(0, 20)));
}

std::size_t Cursor::checkedCount(std::int64_t number, std::size_t least_bytes) const
{
	if (number < 0 ||
	    static_cast<std::uint64_t>(number) > (text_.size() - at_) / std::max<std::size_t>(least_bytes, 1) + 1)
		throw damaged(fmt::format("it announces {} of something, more than it has room for", number));
	return static_cast<std::size_t>(number);
}

const char* Cursor::take(std::size_t bytes)
{
	if (text_.size() - at_ < bytes)
		endsEarly();
	at_ += bytes;
	return text_.data() + at_ - bytes;
}

void Cursor::skipPast(std::string_view wanted)
{
	for (std::size_t found = text_.find(wanted, at_); found != text_.npos; found = text_.find(wanted, found + 1))
	{
		const std::size_t end = found + wanted.size();
		const bool begins_line = found == 0 || text_[found - 1] == '\n';
		if (begins_line && (end == text_.size() || isSpace(text_[end])))
		{
			at_ = end;
			return;
		}
	}
	throw damaged(fmt::format("it has no {}", wanted));
}

} // namespace vp::reader::text
