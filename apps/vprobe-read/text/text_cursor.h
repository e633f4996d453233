#pragma once

#include "vprobe-read/base/bytes.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace vp::reader::text
{

// Walks through the numbers of a file, which are text or, if the file says so, bytes. Throws a Refusal past the end,
// and if a word is not a number but should be one.
class Cursor
{
public:
	explicit Cursor(std::string_view text) : text_(text) {}

	bool atEnd(); // behind white space
	std::string_view line();
	std::string_view word();     // between white space
	std::string_view peekLine(); // the next one that is not blank, without its white space
	std::int64_t integer();
	double real(); // in every spelling of base/real_text.h
	// Returns a number of items that take at least so many bytes each. Throws a Refusal if the rest cannot hold them.
	std::size_t count(std::size_t least_bytes = 2) { return checkedCount(integer(), least_bytes); }
	std::size_t checkedCount(std::int64_t number, std::size_t least_bytes) const;

	template <class Number>
	Number binary();
	void setOrder(ByteOrder order) { order_ = order; }

	std::size_t place() const { return at_; }
	void moveTo(std::size_t place) { at_ = place; }
	// Skips past the next line that equals this one. Throws a Refusal if there is none.
	void skipPast(std::string_view line);

	[[noreturn]] void endsEarly() const;

private:
	void skipSpace();
	const char* take(std::size_t bytes);

	std::string_view text_;
	std::size_t at_ = 0;
	ByteOrder order_ = ByteOrder::little;
};

template <class Number>
Number Cursor::binary()
{
	return numberAt<Number>(take(sizeof(Number)), order_);
}

} // namespace vp::reader::text
