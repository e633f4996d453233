#pragma once

#include "grid/field.h"
#include "vprobe-read/text/xml_tree.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vp::reader::quick
{

// An array of a VTK XML file, and how many values it must have.
struct XmlArray
{
	enum class Form
	{
		text,
		inline_bytes,
		appended
	};

	text::XmlElement* element = nullptr;
	std::string words;                    // that name it: "the point array c"
	Form form = Form::text;               // as VTK's readers take it
	std::optional<grid::NumberType> type; // none for text, bits and types that there are not
	std::optional<std::uint64_t> values;  // none where the file does not say it
	std::optional<std::size_t> offsets;   // the array of the list whose last value says it

	// Throws a Refusal unless the array has as many values as it must have. there: the number that it has. last_offset:
	// the last value of the array of offsets, if there is one.
	void check(std::uint64_t there, std::int64_t last_offset) const;
};

// Returns all arrays of the element that is named like the file's type. Throws a Refusal if the size of a piece is not
// a number.
std::vector<XmlArray> arraysOfXml(text::XmlElement& data);

// The numbers of points and cells of a piece. In polygonal data, cells of all kinds count.
struct PieceSizes
{
	std::uint64_t points = 0;
	std::uint64_t cells = 0;
	std::optional<std::array<std::uint64_t, 3>> lattice; // points along each axis
};
std::optional<PieceSizes> sizesOfPiece(const text::XmlElement& piece);

// Gives arrays of one association that have the same name, or none, names of their own, in all pieces of a file or in
// an index of pieces. Returns a line for each name.
std::vector<std::string> giveOwnNames(text::XmlElement& data);

// Arrays, such as "point array c", with their types and numbers of components.
using Fields = std::map<std::string, std::string>;
// Returns the point and cell arrays of a piece, or those that an index of pieces names.
Fields fieldsOf(const text::XmlElement& piece);
// Throws a Refusal unless all pieces of a file have the same arrays. VTK's reader would return uninitialized memory for
// missing ones.
void refuseOtherFields(const text::XmlElement& data);

// Removes keys of arrays whose numbers are not finite, because VTK's readers fail on them, though VTK writes them. They
// are ranges, which are computed anew. Returns true if there was one.
bool leaveOutStrangeKeys(text::XmlElement& data);

// Rewrites the numbers of attributes such as Origin so that VTK's readers understand them. Returns true if one was
// rewritten. Throws a Refusal if one is not a finite number, and for too few or too many.
bool respellAttributes(text::XmlElement& data);

} // namespace vp::reader::quick
