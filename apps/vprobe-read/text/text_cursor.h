#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

// Walks through the numbers of a file, written as text or, where the file says so, as bytes. What lies past the end,
// and what is no number where one is wanted, is a Refusal.
class TextCursor
{
public:
	explicit TextCursor(std::string_view text) : text_(text) {}

	bool atEnd(); // behind white space
	std::string_view line();
	std::string_view word();     // between white space
	std::string_view peekLine(); // the next one that is not blank, without its white space
	std::int64_t integer();
	double real(); // in every spelling of base/real_text.h
	// A number of things that take so many bytes each, at the least; refused if they cannot be in the rest.
	std::size_t count(std::size_t least_bytes = 2) { return checkedCount(integer(), least_bytes); }
	std::size_t checkedCount(std::int64_t number, std::size_t least_bytes) const;

	template <class Number>
	Number binary();
	void setSwaps(bool swaps) { swaps_ = swaps; }

	std::size_t place() const { return at_; }
	void moveTo(std::size_t place) { at_ = place; }
	// Behind the next line that is this one. A Refusal if there is none.
	void skipPast(std::string_view line);

	[[noreturn]] void endsEarly() const;

private:
	void skipSpace();
	void take(void* number, std::size_t bytes);

	std::string_view text_;
	std::size_t at_ = 0;
	bool swaps_ = false;
};

template <class Number>
Number TextCursor::binary()
{
	Number number;
	take(&number, sizeof number);
	return number;
}
