#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vp::reader::text
{

// Texts between tags are kept up to this length.
constexpr std::size_t kMaxShortText = 4096;

// An element of a VTK XML file, without the data of its arrays.
struct XmlElement
{
	std::string name;
	std::vector<std::pair<std::string, std::string>> attributes;
	std::vector<XmlElement> children;
	std::string text;                // where it is short, or entities are expanded
	std::uint64_t content_begin = 0; // what stands between its tags, by its place in the file
	std::uint64_t content_end = 0;
	bool is_from_entity = false; // what stands between its tags is nowhere in the file then

	// Empty where the element has no such attribute.
	std::string_view attribute(std::string_view wanted) const;
	bool has(std::string_view wanted) const;
};

struct XmlFile
{
	XmlElement root;
	// The bytes of <AppendedData>, from behind the underscore. None where the encoding is empty.
	std::string appended_encoding;
	std::uint64_t appended_begin = 0;
	std::uint64_t appended_end = 0;
};

enum class DocumentType
{
	refused, // no writer of VTK's files makes one
	internal // entities that the file itself declares are expanded; the limits of expat against blow-up hold
};

// Parses the elements of a file. The data of arrays, appended or not, are passed over. Nothing where the text is not
// well formed, or has what no writer of these files makes, such as elements that are nested deeply. Throws a Refusal
// for an entity that only another file could declare: no other file is ever opened.
std::optional<XmlFile> parseXml(std::string_view text, DocumentType type = DocumentType::refused);

} // namespace vp::reader::text
