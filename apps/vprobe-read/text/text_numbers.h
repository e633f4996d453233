#pragma once

#include "grid/field.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/memory_file.h"

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace vp::reader::text
{

// Describes the numbers of an array in text.
struct Numbers
{
	std::uint64_t count = 0;
	std::int64_t last = 0;    // the last of whole numbers; 0 if there are none
	bool is_strange = false;  // whether a number is written in a way that VTK's readers do not know: nan, 1D2, 1.0-100
	std::uint64_t behind = 0; // the place behind the numbers
};

// Says where a text ends, and where its numbers go.
struct NumberTarget
{
	MemoryFile* to = nullptr; // nullptr: they are only looked at
	ByteOrder order = ByteOrder::little;
	std::uint64_t most = std::numeric_limits<std::uint64_t>::max(); // stops behind so many
	bool is_xml = false;                                            // tags and comments may stand in between
};

// Reads the numbers of a text in every spelling of base/real_text.h. Integers may be written as 1.0 or 1e3. Throws a
// Refusal, which names the array and the word, if a word is not a number or does not fit into the type.
Numbers readNumbers(std::string_view text, grid::NumberType type, const std::string& array, const NumberTarget& target);

// The length of the comment, or of the element with all that it holds, at which a text begins; 0 if it does not end.
std::size_t lengthOfMarkup(std::string_view text);

} // namespace vp::reader::text
