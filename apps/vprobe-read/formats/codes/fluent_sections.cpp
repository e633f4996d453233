#include "fluent_sections.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <charconv>

namespace vp::reader::codes
{

namespace
{

// Fluent writes this in its section 4 on machines with little endian numbers.
constexpr std::string_view kFluentLittleEndian = "60";

bool isFluentBlank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r');
}

} // namespace

std::vector<std::int64_t> FluentSection::numbers(int base) const
{
	std::vector<std::int64_t> all;
	for (std::size_t at = 0; at < head.size();)
	{
		if (isFluentBlank(head[at]))
		{
			++at;
			continue;
		}
		std::int64_t value = 0;
		const auto [stop, error] = std::from_chars(head.data() + at, head.data() + head.size(), value, base);
		if (error != std::errc() || (stop != head.data() + head.size() && !isFluentBlank(*stop)))
			throw damaged(fmt::format("section {} does not begin with numbers", number));
		all.push_back(value);
		at = static_cast<std::size_t>(stop - head.data());
	}
	return all;
}

// The place of the parenthesis that closes the list whose inside begins at `start`. Text in quotes may hold others.
std::size_t FluentSections::endOfList(std::size_t start) const
{
	int level = 1;
	bool quoted = false;
	for (std::size_t at = start; at < text_.size(); ++at)
		if (text_[at] == '"' && text_[at - 1] != '\\')
			quoted = !quoted;
		else if (!quoted && text_[at] == '(')
			++level;
		else if (!quoted && text_[at] == ')' && --level == 0)
			return at;
	at_.endsEarly();
}

bool FluentSections::next(FluentSection& section)
{
	const std::size_t start = text_.find('(', at_.place());
	if (start == text_.npos)
		return false;
	section = {};
	std::size_t at = start + 1;
	while (at < text_.size() && isFluentBlank(text_[at]))
		++at;
	const auto [end, error] = std::from_chars(text_.data() + at, text_.data() + text_.size(), section.number);
	if (error != std::errc() || section.number < 0)
		throw damaged("a section without a number");
	section.is_binary = section.number >= 2000;
	at = static_cast<std::size_t>(end - text_.data());
	while (at < text_.size() && isFluentBlank(text_[at]))
		++at;
	if (at >= text_.size())
		at_.endsEarly();
	if (text_[at] != '(') // a comment, or plain numbers
	{
		const std::size_t close = endOfList(at);
		section.head = text_.substr(at, close - at);
		at_.moveTo(close + 1);
		return true;
	}
	const std::size_t close = endOfList(at + 1);
	section.head = text_.substr(at + 1, close - at - 1);
	if (section.kind() == 4 && !section.is_binary)
		order_ = byteOrder(!section.head.starts_with(kFluentLittleEndian));
	at = close + 1;
	while (at < text_.size() && isFluentBlank(text_[at]))
		++at;
	if (at < text_.size() && text_[at] == '(')
	{
		section.body = at + 1;
		section.end = section.is_binary ? text_.size() : endOfList(section.body);
	}
	at_.moveTo(section.is_binary && section.body ? section.body : endOfList(start + 1) + 1);
	return true;
}

text::Cursor FluentSections::bodyOf(const FluentSection& section) const
{
	text::Cursor body(text_.substr(0, section.end));
	body.moveTo(section.body);
	body.setOrder(order_);
	return body;
}

std::size_t FluentSections::endOfBinary(std::size_t from) const
{
	const std::size_t end = text_.find("End of Binary Section", from);
	if (end == text_.npos)
		at_.endsEarly();
	return end;
}

void FluentSections::endBody(const FluentSection& section, text::Cursor& body)
{
	// Between the bytes and the mark of their end are a line end and a parenthesis.
	constexpr std::size_t kMaxBetween = 8;
	if (section.is_binary ? endOfBinary(body.place()) - body.place() > kMaxBetween : !body.atEnd())
		throw damaged(fmt::format("section {} is longer than it announces", section.number));
	skip(section);
}

void FluentSections::skip(const FluentSection& section)
{
	if (!section.is_binary || section.body == 0)
		return;
	const std::size_t close = text_.find(')', endOfBinary(at_.place()));
	if (close == text_.npos)
		at_.endsEarly();
	at_.moveTo(close + 1);
}

std::int64_t hexadecimalWord(text::Cursor& at)
{
	const std::string_view digits = at.word();
	std::int64_t value = 0;
	const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
	if (error != std::errc() || end != digits.data() + digits.size())
		throw damaged(fmt::format("\"{}\" where a hexadecimal number is wanted", digits.substr(0, 20)));
	return value;
}

} // namespace vp::reader::codes
