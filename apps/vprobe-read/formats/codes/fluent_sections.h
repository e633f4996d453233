#pragma once

#include "vprobe-read/base/bytes.h"
#include "vprobe-read/text/text_cursor.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace vp::reader::codes
{

// A part of a Fluent case or data file: "(NUMBER (HEAD) (BODY))", in text or, from number 2000 on, with a binary body.
struct FluentSection
{
	int number = 0;
	std::string_view head; // the words of the first list
	std::size_t body = 0;  // where the second list begins, behind its parenthesis; 0 where there is none
	std::size_t end = 0;   // the end of that list, or of the file if it is binary
	bool is_binary = false;

	// The number without what tells its kind: 10 of 2010 and 3010.
	int kind() const { return is_binary ? number % 1000 : number; }
	// All numbers of the head, of base 10 or 16.
	std::vector<std::int64_t> numbers(int base) const;
};

// Walks through the sections of a file. What comes behind an end that was cut off is a Refusal.
class FluentSections
{
public:
	explicit FluentSections(std::string_view text) : text_(text), at_(text) {}

	bool next(FluentSection& section);
	// A reader that stands at the body of the section, with the order of bytes that the file told so far.
	text::Cursor bodyOf(const FluentSection& section) const;
	// Goes on behind a section whose body was read. It must end where its reading did.
	void endBody(const FluentSection& section, text::Cursor& body);
	void skip(const FluentSection& section);
	// As of a text::Cursor at the start of the file.
	std::size_t checkedCount(std::int64_t number, std::size_t least_bytes) const
	{
		return text::Cursor(text_).checkedCount(number, least_bytes);
	}

private:
	std::size_t endOfList(std::size_t start) const;
	std::size_t endOfBinary(std::size_t from) const;

	std::string_view text_;
	text::Cursor at_;
	ByteOrder order_ = ByteOrder::little;
};

// A whole number in hexadecimal.
std::int64_t hexadecimalWord(text::Cursor& at);

} // namespace vp::reader::codes
