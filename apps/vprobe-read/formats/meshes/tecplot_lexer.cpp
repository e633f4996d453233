#include "tecplot_lexer.h"

#include "base/real_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace vp::reader::meshes
{

namespace
{

bool isBetweenWords(char c)
{
	return c == ',' || std::isspace(static_cast<unsigned char>(c));
}

bool isTecplotSign(char c)
{
	return c == '=' || c == '(' || c == ')' || c == '"' || c == '\'';
}

} // namespace

void TecplotLexer::skipBlanks()
{
	while (at_ < text_.size() && (isBetweenWords(text_[at_]) || text_[at_] == '#'))
		at_ = text_[at_] == '#' ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
}

bool TecplotLexer::atEnd()
{
	skipBlanks();
	return at_ == text_.size();
}

bool TecplotLexer::isNumber()
{
	TecplotLexer ahead = *this;
	if (ahead.atEnd())
		return false;
	std::string_view word = ahead.bareWord();
	if (const auto star = word.find('*'); star != word.npos)
		word.remove_prefix(star + 1);
	return parseReal(word) && !ahead.isNext('=');
}

bool TecplotLexer::isString()
{
	skipBlanks();
	return at_ < text_.size() && (text_[at_] == '"' || text_[at_] == '\'');
}

std::string_view TecplotLexer::bareWord()
{
	skipBlanks();
	const std::size_t begin = at_;
	while (at_ < text_.size() && !isBetweenWords(text_[at_]) && !isTecplotSign(text_[at_]))
		++at_;
	if (at_ == text_.size() && begin == at_)
		throw damaged("it ends before all that it announces");
	return text_.substr(begin, at_ - begin);
}

std::string TecplotLexer::word()
{
	std::string word(bareWord());
	std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::toupper(c); });
	return word;
}

std::string TecplotLexer::text()
{
	if (!isString())
		return std::string(bareWord());
	const char quote = text_[at_];
	std::string words;
	for (std::size_t at = at_ + 1; at < text_.size(); ++at)
	{
		const bool is_escaped =
		    text_[at] == '\\' && at + 1 < text_.size() && (text_[at + 1] == quote || text_[at + 1] == '\\');
		if (text_[at] == quote)
		{
			at_ = at + 1;
			return words;
		}
		words += text_[is_escaped ? ++at : at];
	}
	throw damaged("a text without its end");
}

bool TecplotLexer::isNext(char sign)
{
	skipBlanks();
	return at_ < text_.size() && text_[at_] == sign;
}

bool TecplotLexer::take(char sign)
{
	if (!isNext(sign))
		return false;
	++at_;
	return true;
}

std::string_view TecplotLexer::list()
{
	if (!isNext('(') && !isNext('['))
		return bareWord();
	const std::size_t start = at_ + 1;
	int depth = 0;
	for (; at_ < text_.size(); ++at_)
	{
		depth += text_[at_] == '(' || text_[at_] == '[';
		depth -= text_[at_] == ')' || text_[at_] == ']';
		if (depth == 0)
			return text_.substr(start, at_++ - start);
	}
	throw damaged("a list without its brackets");
}

std::int64_t TecplotLexer::integer()
{
	return text::Cursor(bareWord()).integer();
}

double TecplotLexer::real()
{
	return text::Cursor(bareWord()).real();
}

double TecplotLexer::value()
{
	if (repeats_ > 0)
	{
		--repeats_;
		return repeated_;
	}
	const std::string_view word = bareWord();
	const auto star = word.find('*');
	if (star == word.npos)
		return text::Cursor(word).real();
	repeats_ = text::Cursor(word.substr(0, star)).integer() - 1;
	repeated_ = text::Cursor(word.substr(star + 1)).real();
	if (repeats_ < 0 || repeats_ > kMaxCount)
		throw damaged(fmt::format("\"{}\" repeats a value impossibly often", word.substr(0, 20)));
	return repeated_;
}

} // namespace vp::reader::meshes
