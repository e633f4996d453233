#pragma once

#include "foam_text.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

// Walks through the words, numbers and lists of a file of OpenFOAM. What lies past the end is a Refusal.
class FoamCursor
{
public:
	explicit FoamCursor(std::string_view text) : text_(text) {}

	// Lists are as the head says.
	void setHead(const FoamHead& head) { head_ = head; }

	// The next character behind white space and comments; 0 at the end.
	char peek();
	bool take(char wanted); // false, and nothing taken, if another is next
	void expect(char wanted);
	// A name, a number, or a text without its quotes; else one character.
	std::string_view word();
	void skipLine();
	// Behind the value of an entry: its semicolon, or the brace that closes it.
	void skipValue();

	std::int64_t integer();
	double real();
	// One element of a field: a number, or several in parentheses.
	void element(int components, std::vector<double>& numbers);
	// A list with the number of its elements before it.
	FoamList reals(int components);
	std::vector<std::int64_t> labels();
	FoamFaces faces(bool is_compact);

private:
	std::size_t count(std::size_t least_bytes);
	template <class Number, class As>
	void bytes(std::size_t count, std::vector<As>& numbers);
	std::string_view number();

	std::string_view text_;
	std::size_t at_ = 0;
	FoamHead head_;
};

// How many numbers the type has that stands in a list's brackets, as "vector"; 0 for other types.
int foamComponents(std::string_view type);
