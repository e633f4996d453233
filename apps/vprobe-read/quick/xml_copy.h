#pragma once

#include "vprobe-read/base/memory_file.h"
#include "vprobe-read/text/xml_tree.h"
#include "xml_arrays.h"

#include <string_view>
#include <vector>

namespace vp::reader::quick
{

// Writes the head of a file and its elements, except for appended data. The data of arrays come from the text.
void writeElements(const text::XmlFile& xml, std::string_view text, MemoryFile& to);
void writeAppendedStart(std::string_view encoding, MemoryFile& to);
void writeEnd(const text::XmlFile& xml, bool has_appended, MemoryFile& to);

// Writes a copy of a file in which all numbers are appended as raw bytes: converted from text in any spelling, and
// unpacked. Throws a Refusal for a word that is not a number, for an array with too few or too many values, and for one
// that cannot be unpacked. path: the file, whose elements are `given`. arrays: the arrays of `xml`, which holds the
// elements that stay.
void writeAsBytes(const std::string& path, const text::XmlFile& given, const text::XmlFile& xml,
                  const std::vector<XmlArray>& arrays, std::string_view text, MemoryFile& to);

// Throws a Refusal for the same reasons, as far as the numbers in front of the arrays show them. Returns true if VTK's
// readers understand every number that is text.
bool checkArrays(const std::string& path, const text::XmlFile& given, const std::vector<XmlArray>& arrays,
                 std::string_view text);

} // namespace vp::reader::quick
