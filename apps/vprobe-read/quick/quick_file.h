#pragma once

#include "grid/field.h"
#include "vprobe-read/arrays/packed_array.h"
#include "vprobe-read/text/xml_tree.h"

#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace vp::reader::quick
{

// Gives the quick reader a VTK XML file: its elements, and its arrays by their elements. All functions throw NotQuick
// if the quick reader does not support the file.
class File
{
public:
	explicit File(const std::string& path);
	~File();
	File(const File&) = delete;
	File& operator=(const File&) = delete;

	std::string_view type() const { return xml_.root.attribute("type"); }
	// Returns the element that is named like the file's type, and so holds the pieces.
	const text::XmlElement& data() const;
	// Opens an array of so many bytes.
	std::shared_ptr<const arrays::PackedArray> open(const text::XmlElement& array, std::uint64_t bytes) const;

private:
	int file_ = -1;
	text::XmlFile xml_;
	arrays::Packing packing_;
};

// Returns how the arrays of a file are packed. Throws NotQuick if that is unknown.
arrays::Packing packingOf(const text::XmlElement& root);

// Opens an array that is appended, or stands inline as base64.
std::shared_ptr<const arrays::PackedArray> openPacked(int file, const text::XmlFile& xml,
                                                      const arrays::Packing& packing, const text::XmlElement& array);

// Returns the type that files write as "Float64", for example. Returns nothing if it is not a number type.
std::optional<grid::NumberType> numberTypeOfXml(std::string_view word);

// The number type and components of a DataArray. Throws NotQuick if the array does not hold numbers.
struct ArrayKind
{
	explicit ArrayKind(const text::XmlElement& array);
	bool operator==(const ArrayKind&) const = default;
	std::uint64_t tupleBytes() const { return std::uint64_t(components) * byteSize(type); }

	grid::NumberType type;
	std::uint32_t components;
};

// Throws NotQuick unless the element has exactly one child of this name.
const text::XmlElement& onlyChild(const text::XmlElement& parent, std::string_view name);

// Returns the numbers of a text, which must have exactly as many as the array.
template <class T, std::size_t N>
std::array<T, N> numbersIn(std::string_view text)
{
	std::array<T, N> numbers{};
	constexpr std::string_view spaces = " \t\n\r";
	for (T& number : numbers)
	{
		text.remove_prefix(std::min(text.find_first_not_of(spaces), text.size()));
		const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
		if (error != std::errc())
			throw arrays::NotQuick();
		text.remove_prefix(static_cast<std::size_t>(end - text.data()));
		if (!text.empty() && spaces.find(text.front()) == spaces.npos)
			throw arrays::NotQuick();
	}
	if (text.find_first_not_of(spaces) != text.npos)
		throw arrays::NotQuick();
	return numbers;
}

} // namespace vp::reader::quick
