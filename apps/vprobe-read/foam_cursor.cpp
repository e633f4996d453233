#include "foam_cursor.h"

#include "base/real_text.h"
#include "refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <optional>

namespace
{

bool isBlank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r');
}

bool isMark(char c)
{
	return c == ';' || c == '{' || c == '}' || c == '(' || c == ')' || c == '[' || c == ']' || c == '"';
}

// Behind parentheses that are a part of a name, as in "grad(T)"; else where it was.
std::size_t pastParentheses(std::string_view text, std::size_t at)
{
	std::size_t depth = 0;
	for (std::size_t end = at; end < text.size() && !isBlank(text[end]); ++end)
	{
		const char c = text[end];
		if (c == '(')
			++depth;
		else if (c == ')' && --depth == 0)
			return end + 1;
		else if (c != ')' && isMark(c))
			break;
	}
	return at;
}

} // namespace

int foamComponents(std::string_view type)
{
	return type == "scalar" || type == "sphericalTensor" ? 1
	       : type == "vector"                            ? 3
	       : type == "symmTensor"                        ? 6
	       : type == "tensor"                            ? 9
	                                                     : 0;
}

char FoamCursor::peek()
{
	while (at_ < text_.size())
	{
		const std::string_view rest = text_.substr(at_, 2);
		if (isBlank(rest[0]))
			++at_;
		else if (rest == "//")
			at_ = std::min(text_.find('\n', at_), text_.size());
		else if (rest == "/*")
		{
			const std::size_t end = text_.find("*/", at_ + 2);
			at_ = end == text_.npos ? text_.size() : end + 2;
		}
		else
			return rest[0];
	}
	return 0;
}

bool FoamCursor::take(char wanted)
{
	if (peek() != wanted || at_ >= text_.size())
		return false;
	++at_;
	return true;
}

void FoamCursor::expect(char wanted)
{
	if (!take(wanted))
		throw damaged(fmt::format("it has no \"{}\" where one is wanted", wanted));
}

std::string_view FoamCursor::word()
{
	peek();
	if (at_ >= text_.size())
		throw damaged("it ends early");
	const std::size_t start = at_++;
	if (text_[start] == '"')
	{
		while (at_ < text_.size() && (text_[at_] != '"' || text_[at_ - 1] == '\\'))
			++at_;
		if (at_ >= text_.size())
			throw damaged("it ends early");
		return text_.substr(start + 1, at_++ - start - 1);
	}
	if (isMark(text_[start]))
		return text_.substr(start, 1);
	const bool is_name = std::isalpha(static_cast<unsigned char>(text_[start]));
	while (at_ < text_.size() && !isBlank(text_[at_]) && !isMark(text_[at_]))
	{
		++at_;
		if (is_name && text_.substr(at_, 1) == "(")
			at_ = pastParentheses(text_, at_);
	}
	return text_.substr(start, at_ - start);
}

void FoamCursor::skipLine()
{
	at_ = std::min(text_.find('\n', at_), text_.size());
}

void FoamCursor::skipValue()
{
	std::size_t depth = 0;
	for (;;)
	{
		const bool is_text = peek() == '"';
		const std::string_view next = word();
		if (is_text)
			continue;
		if (next == "{" || next == "(" || next == "[")
			++depth;
		else if (next == "}" || next == ")" || next == "]")
		{
			if (depth == 0)
				throw damaged("a bracket closes what none has opened");
			if (--depth == 0 && next == "}")
			{
				take(';');
				return;
			}
		}
		else if (next == ";" && depth == 0)
			return;
		else if (head_.is_binary && next.starts_with("List<") && next.ends_with(">"))
		{
			const std::string_view type = next.substr(5, next.size() - 6);
			if (const int components = foamComponents(type))
				reals(components);
			else if (type == "label")
				labels();
			else
				throw damaged(fmt::format("its list of {} is not understood", type.substr(0, 20)));
		}
	}
}

std::string_view FoamCursor::number()
{
	peek();
	const std::size_t start = at_;
	while (at_ < text_.size() && !isBlank(text_[at_]) && !isMark(text_[at_]))
		++at_;
	std::string_view digits = text_.substr(start, at_ - start);
	if (digits.size() > 1 && digits[0] == '+')
		digits.remove_prefix(1);
	return digits;
}

std::int64_t FoamCursor::integer()
{
	const std::string_view digits = number();
	std::int64_t value = 0;
	const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
	if (error != std::errc() || end != digits.data() + digits.size())
		throw damaged(fmt::format("\"{}\" where a whole number is wanted", digits.substr(0, 20)));
	return value;
}

double FoamCursor::real()
{
	const std::string_view digits = number();
	if (const std::optional<double> value = vp::parseReal(digits))
		return *value;
	throw damaged(fmt::format("\"{}\" where a number is wanted", digits.substr(0, 20)));
}

void FoamCursor::element(int components, std::vector<double>& numbers)
{
	const bool in_parentheses = take('(');
	if (components > 1 && !in_parentheses)
		throw damaged("it has no \"(\" where one is wanted");
	for (int i = 0; i < components; ++i)
		numbers.push_back(real());
	if (in_parentheses)
		expect(')');
}

// The number of things that take so many bytes each, at the least.
std::size_t FoamCursor::count(std::size_t least_bytes)
{
	const std::int64_t number = integer();
	if (number < 0 || static_cast<std::uint64_t>(number) > (text_.size() - at_) / least_bytes + 1)
		throw damaged(fmt::format("it announces {} of something, more than it has room for", number));
	return static_cast<std::size_t>(number);
}

template <class Number, class As>
void FoamCursor::bytes(std::size_t count, std::vector<As>& numbers)
{
	if (count > (text_.size() - at_) / sizeof(Number))
		throw damaged("it ends before all that it announces");
	numbers.resize(count);
	for (As& number : numbers)
	{
		Number as_written;
		std::memcpy(&as_written, text_.data() + at_, sizeof as_written);
		at_ += sizeof as_written;
		number = static_cast<As>(as_written);
	}
}

FoamList FoamCursor::reals(int components)
{
	FoamList list = {components, false, {}};
	const std::int64_t announced = integer();
	if (announced < 0)
		throw damaged("a list has fewer than no elements");
	const auto elements = static_cast<std::size_t>(announced);
	if (take('{')) // all are alike
	{
		list.is_uniform = true;
		element(components, list.numbers);
		expect('}');
		return list;
	}
	if (elements == 0)
	{
		if (take('('))
			expect(')');
		return list;
	}
	expect('(');
	const auto per = static_cast<std::size_t>(components);
	if (elements > (text_.size() - at_) / per) // a number takes one byte, at the least
		throw damaged(fmt::format("it announces {} of something, more than it has room for", elements));
	if (head_.is_binary && head_.scalar_bytes == 4)
		bytes<float>(elements * per, list.numbers);
	else if (head_.is_binary)
		bytes<double>(elements * per, list.numbers);
	else
	{
		list.numbers.reserve(elements * per);
		for (std::size_t i = 0; i < elements; ++i)
			element(components, list.numbers);
	}
	expect(')');
	return list;
}

std::vector<std::int64_t> FoamCursor::labels()
{
	std::vector<std::int64_t> list;
	const std::size_t elements = count(1);
	if (elements == 0)
	{
		if (take('('))
			expect(')');
		return list;
	}
	expect('(');
	if (head_.is_binary && head_.label_bytes == 8)
		bytes<std::int64_t>(elements, list);
	else if (head_.is_binary)
		bytes<std::int32_t>(elements, list);
	else
		for (std::size_t i = 0; i < elements; ++i)
			list.push_back(integer());
	expect(')');
	return list;
}

FoamFaces FoamCursor::faces(bool is_compact)
{
	FoamFaces faces;
	if (is_compact)
	{
		faces.starts = labels();
		faces.corners = labels();
		const auto end = static_cast<std::int64_t>(faces.corners.size());
		if (faces.starts.empty() || faces.starts.front() != 0 || faces.starts.back() != end ||
		    !std::is_sorted(faces.starts.begin(), faces.starts.end()))
			throw damaged("its faces do not match their corners");
		return faces;
	}
	const std::size_t elements = count(4);
	expect('(');
	for (std::size_t i = 0; i < elements; ++i)
	{
		const std::vector<std::int64_t> corners = labels();
		faces.corners.insert(faces.corners.end(), corners.begin(), corners.end());
		faces.starts.push_back(static_cast<std::int64_t>(faces.corners.size()));
	}
	expect(')');
	return faces;
}
