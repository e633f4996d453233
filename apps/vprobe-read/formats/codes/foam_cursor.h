#pragma once

#include "foam_text.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace vp::reader::codes
{

struct FoamToken
{
	enum class Kind
	{
		word,      // a name or a number
		text,      // without its quotes
		mark,      // one of ; { } ( ) [ ]
		macro,     // the name behind the $, without its braces
		directive, // with its #
		verbatim,  // between #{ and #}
		list       // text is its type, as "List<scalar>"
	};
	Kind kind;
	std::string_view text;
	std::shared_ptr<const FoamList> list; // null if its elements are no scalars, vectors or tensors

	bool isMark(char c) const { return kind == Kind::mark && text[0] == c; }
};

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
	FoamToken token();
	// Returns the rest of this line.
	std::string_view restOfLine();

	std::int64_t integer();
	// One element of a field: a number, or several in parentheses.
	void element(int components, std::vector<double>& numbers);
	// A list, mostly with the number of its elements before it.
	FoamList reals(int components);
	// Equal labels take no room: at most so many of them.
	std::vector<std::int64_t> labels(std::size_t most_equal = kMaxEqual);
	FoamFaces faces(bool is_compact);
	// Bytes in parentheses behind their number. They may be anything.
	std::string_view block();
	// All that is left.
	std::string_view rest() const { return text_.substr(at_); }

private:
	static constexpr std::size_t kMaxEqual = 1 << 16;

	// Appends a list of labels.
	void takeLabels(std::vector<std::int64_t>& list, std::size_t most_equal);
	double real();
	FoamToken macro();
	FoamToken listOrWord(std::string_view word);
	bool beginsComment() const;
	std::size_t checkedCount(std::int64_t number, std::size_t least_bytes) const;
	template <class Number, class As>
	void bytes(std::size_t count, std::vector<As>& numbers);
	std::string_view number();

	std::string_view text_;
	std::size_t at_ = 0;
	FoamHead head_;
};

// How many numbers the type has that stands in a list's brackets, as "vector"; 0 for other types.
int foamComponents(std::string_view type);

} // namespace vp::reader::codes
