#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace vp::reader::meshes
{

// Walks through a Tecplot text file: words, strings, numbers, and signs. Blanks, commas and comments stand between.
class TecplotLexer
{
public:
	explicit TecplotLexer(std::string_view text) : text_(text) {}

	bool atEnd();
	bool isNumber(); // whether one comes next
	bool isString();
	// A word, in capital letters.
	std::string word();
	// A word or string as it stands, without its quotes.
	std::string text();
	// Takes the sign if it comes next.
	bool take(char sign);
	bool isNext(char sign);
	// A list in () or [], which comes next, without its outermost brackets; else a word.
	std::string_view list();
	std::int64_t integer();
	double real();
	// The next of many numbers, which may be written 8*0.5 for eight of them.
	double value();
	// False while some of the numbers that one word repeats are still to be taken.
	bool isBetweenValues() const { return repeats_ == 0; }
	// Bytes that are left.
	std::size_t left() const { return text_.size() - at_; }
	// A number of values or cells. Repeated ones take no room, but no more than so many are believed.
	static constexpr std::int64_t kMaxCount = std::int64_t(1) << 32;

private:
	void skipBlanks();
	std::string_view bareWord();

	std::string_view text_;
	std::size_t at_ = 0;
	std::int64_t repeats_ = 0;
	double repeated_ = 0.0;
};

} // namespace vp::reader::meshes
