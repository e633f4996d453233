#include "tecplot_lexer.h"

#include "refusal.h"
#include "text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace
{

bool isBlank(char c)
{
	return c == ',' || std::isspace(static_cast<unsigned char>(c));
}

bool isSign(char c)
{
	return c == '=' || c == '(' || c == ')' || c == '"' || c == '\'';
}

} // namespace

void TecplotLexer::skipBlanks()
{
	while (at_ < text_.size() && (isBlank(text_[at_]) || text_[at_] == '#'))
		at_ = text_[at_] == '#' ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
}

bool TecplotLexer::atEnd()
{
	skipBlanks();
	return at_ == text_.size();
}

bool TecplotLexer::isNumber()
{
	skipBlanks();
	std::size_t at = at_;
	if (at < text_.size() && (text_[at] == '-' || text_[at] == '+'))
		++at;
	if (at < text_.size() && text_[at] == '.')
		++at;
	return at < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at]));
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
	while (at_ < text_.size() && !isBlank(text_[at_]) && !isSign(text_[at_]))
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
	const std::size_t end = text_.find(quote, at_ + 1);
	if (end == text_.npos)
		throw damaged("a text without its end");
	std::string words(text_.substr(at_ + 1, end - at_ - 1));
	at_ = end + 1;
	return words;
}

bool TecplotLexer::take(char sign)
{
	skipBlanks();
	if (at_ == text_.size() || text_[at_] != sign)
		return false;
	++at_;
	return true;
}

std::string_view TecplotLexer::group()
{
	skipBlanks();
	const std::size_t end = std::min(text_.find(')', at_), text_.size());
	if (at_ == text_.size() || text_[at_] != '(' || end == text_.size())
		throw damaged("a list without its brackets");
	const std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
	at_ = end + 1;
	return inside;
}

std::int64_t TecplotLexer::integer()
{
	return TextCursor(bareWord()).integer();
}

double TecplotLexer::real()
{
	return TextCursor(bareWord()).real();
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
		return TextCursor(word).real();
	repeats_ = TextCursor(word.substr(0, star)).integer() - 1;
	repeated_ = TextCursor(word.substr(star + 1)).real();
	if (repeats_ < 0 || repeats_ > kMaxCount)
		throw damaged(fmt::format("\"{}\" repeats a value impossibly often", word.substr(0, 20)));
	return repeated_;
}
