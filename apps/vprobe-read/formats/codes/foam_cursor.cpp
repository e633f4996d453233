#include "foam_cursor.h"

#include "base/real_text.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

namespace vp::reader::codes
{

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
		else if (rest[0] != '/')
			return rest[0];
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

bool FoamCursor::beginsComment() const
{
	const std::string_view rest = text_.substr(at_, 2);
	return rest == "//" || rest == "/*";
}

FoamToken FoamCursor::token()
{
	using Kind = FoamToken::Kind;
	peek();
	if (at_ >= text_.size())
		throw damaged("it ends early");
	const std::size_t start = at_++;
	const char first = text_[start];
	if (first == '"')
	{
		while (at_ < text_.size() && (text_[at_] != '"' || text_[at_ - 1] == '\\'))
			++at_;
		if (at_ >= text_.size())
			throw damaged("it ends early");
		return {Kind::text, text_.substr(start + 1, at_++ - start - 1), nullptr};
	}
	if (isMark(first))
		return {Kind::mark, text_.substr(start, 1), nullptr};
	if (first == '$')
		return macro();
	if (text_.substr(start, 2) == "#{")
	{
		const std::size_t end = text_.find("#}", start);
		if (end == text_.npos)
			throw damaged("it ends early");
		at_ = end + 2;
		return {Kind::verbatim, text_.substr(start + 2, end - start - 2), nullptr};
	}
	const bool is_name = std::isalpha(static_cast<unsigned char>(first));
	while (at_ < text_.size() && !isBlank(text_[at_]) && !isMark(text_[at_]) && !beginsComment())
	{
		++at_;
		if (is_name && text_.substr(at_, 1) == "(")
			at_ = pastParentheses(text_, at_);
	}
	const std::string_view word = text_.substr(start, at_ - start);
	return first == '#' ? FoamToken{Kind::directive, word, nullptr} : listOrWord(word);
}

// Behind its $: a name, or one in braces.
FoamToken FoamCursor::macro()
{
	const bool in_braces = at_ < text_.size() && text_[at_] == '{';
	const std::size_t start = at_ + in_braces;
	std::size_t end = start;
	if (in_braces)
	{
		end = text_.find('}', start);
		if (end == text_.npos)
			throw damaged("it ends early");
		at_ = end + 1;
	}
	else
	{
		while (at_ < text_.size() && !isBlank(text_[at_]) && !isMark(text_[at_]) && !beginsComment())
			++at_;
		end = at_;
	}
	return {FoamToken::Kind::macro, text_.substr(start, end - start), nullptr};
}

FoamToken FoamCursor::listOrWord(std::string_view word)
{
	using Kind = FoamToken::Kind;
	if (!word.starts_with("List<") || !word.ends_with(">"))
		return {Kind::word, word, nullptr};
	const std::string_view type = word.substr(5, word.size() - 6);
	if (const int components = foamComponents(type))
		return {Kind::list, word, std::make_shared<const FoamList>(reals(components))};
	if (type == "label")
	{
		labels();
		return {Kind::list, word, nullptr};
	}
	// Bytes stand for themselves; lists of words are text even then.
	if (head_.is_binary && type == "bool")
	{
		std::vector<char> values;
		const std::size_t elements = checkedCount(integer(), 1);
		if (take('('))
		{
			bytes<char>(elements, values);
			expect(')');
		}
		return {Kind::list, word, nullptr};
	}
	if (head_.is_binary && type != "word" && type != "string" && type != "keyType" && type != "fileName")
		throw Refusal(fmt::format("its list of {} in bytes is not read; save the case as text with foamFormatConvert",
		                          type.substr(0, 20)));
	return {Kind::word, word, nullptr};
}

std::string_view FoamCursor::restOfLine()
{
	const std::size_t start = std::min(at_, text_.size());
	at_ = std::min(text_.find('\n', start), text_.size());
	return text_.substr(start, at_ - start);
}

std::string_view FoamCursor::number()
{
	peek();
	const std::size_t start = at_;
	while (at_ < text_.size() && !isBlank(text_[at_]) && !isMark(text_[at_]) && (text_[at_] != '/' || !beginsComment()))
		++at_;
	std::string_view digits = text_.substr(start, at_ - start);
	if (digits.size() > 1 && digits[0] == '+')
		digits.remove_prefix(1);
	return digits;
}

std::int64_t FoamCursor::integer()
{
	peek();
	std::int64_t value = 0;
	const std::string_view rest = text_.substr(at_);
	const char* last = rest.data() + rest.size();
	if (const auto [end, error] = std::from_chars(rest.data(), last, value);
	    error == std::errc() && (end == last || isBlank(*end) || isMark(*end)))
	{
		at_ += static_cast<std::size_t>(end - rest.data());
		return value;
	}
	const std::string_view digits = number();
	const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
	if (error != std::errc() || end != digits.data() + digits.size())
		throw damaged(fmt::format("\"{}\" where a whole number is wanted", digits.substr(0, 20)));
	return value;
}

double FoamCursor::real()
{
	const std::string_view digits = number();
	if (const std::optional<double> value = parseReal(digits))
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
std::size_t FoamCursor::checkedCount(std::int64_t number, std::size_t least_bytes) const
{
	if (number < 0 || static_cast<std::uint64_t>(number) > (text_.size() - at_) / least_bytes + 1)
		throw damaged(fmt::format("it announces {} of something, more than it has room for", number));
	return static_cast<std::size_t>(number);
}

template <class Number, class As>
void FoamCursor::bytes(std::size_t count, std::vector<As>& numbers)
{
	if (count > (text_.size() - at_) / sizeof(Number))
		throw damaged("it ends before all that it announces");
	const std::size_t before = numbers.size();
	numbers.resize(before + count);
	for (std::size_t i = before; i < numbers.size(); ++i)
	{
		numbers[i] = static_cast<As>(numberAt<Number>(text_.data() + at_, byteOrder(head_.is_big_endian)));
		at_ += sizeof(Number);
	}
}

FoamList FoamCursor::reals(int components)
{
	FoamList list;
	list.components = components;
	if (!head_.is_binary && take('(')) // without its count
	{
		while (peek() != ')')
			element(components, list.numbers);
		expect(')');
		return list;
	}
	const std::int64_t announced = integer();
	if (announced < 0)
		throw damaged("a list has fewer than no elements");
	const auto elements = static_cast<std::size_t>(announced);
	if (take('{')) // all are alike
	{
		list.is_uniform = true;
		list.announced = elements;
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

std::vector<std::int64_t> FoamCursor::labels(std::size_t most_equal)
{
	std::vector<std::int64_t> list;
	takeLabels(list, most_equal);
	return list;
}

void FoamCursor::takeLabels(std::vector<std::int64_t>& list, std::size_t most_equal)
{
	const std::int64_t announced = integer();
	if (announced >= 0 && take('{')) // all are alike
	{
		if (static_cast<std::size_t>(announced) > most_equal)
			throw damaged(fmt::format("it announces {} of something, more than there can be", announced));
		list.insert(list.end(), static_cast<std::size_t>(announced), integer());
		expect('}');
		return;
	}
	const std::size_t elements = checkedCount(announced, 1);
	if (elements == 0)
	{
		if (take('('))
			expect(')');
		return;
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
}

std::string_view FoamCursor::block()
{
	const std::size_t size = checkedCount(integer(), 1);
	expect('(');
	const std::string_view bytes = text_.substr(at_, size);
	at_ += bytes.size();
	expect(')');
	return bytes;
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
	const std::size_t elements = checkedCount(integer(), 4);
	if (elements == 0 && !take('('))
		return faces;
	if (elements > 0)
		expect('(');
	for (std::size_t i = 0; i < elements; ++i)
	{
		takeLabels(faces.corners, kMaxEqual);
		faces.starts.push_back(static_cast<std::int64_t>(faces.corners.size()));
	}
	expect(')');
	return faces;
}

} // namespace vp::reader::codes
