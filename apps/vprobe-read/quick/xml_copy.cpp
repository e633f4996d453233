#include "xml_copy.h"

#include "parts/part_bytes.h"
#include "quick_file.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/text_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>

#include <fcntl.h>
#include <unistd.h>

namespace vp::reader::quick
{

using grid::NumberType;

namespace
{

std::string escapedText(std::string_view text)
{
	std::string words;
	for (const char c : text)
	{
		const bool is_plain =
		    static_cast<unsigned char>(c) >= 0x20 && !isOneOf(std::string_view(&c, 1), {"&", "<", "\""});
		words += is_plain ? std::string(1, c) : fmt::format("&#{};", static_cast<int>(static_cast<unsigned char>(c)));
	}
	return words;
}

std::string startTag(const text::XmlElement& element, std::initializer_list<std::string_view> left_out = {})
{
	std::string tag = "<" + element.name;
	for (const auto& [name, value] : element.attributes)
		if (!isOneOf(name, left_out))
			tag += fmt::format(" {}=\"{}\"", name, escapedText(value));
	return tag;
}

std::string_view contentOf(const text::XmlElement& element, std::string_view text)
{
	const std::uint64_t end = std::min<std::uint64_t>(element.content_end, text.size());
	return element.content_begin < end ? text.substr(element.content_begin, end - element.content_begin)
	                                   : std::string_view();
}

bool isArray(const text::XmlElement& element)
{
	return isOneOf(element.name, {"DataArray", "Array"});
}

bool isBlankText(std::string_view text)
{
	return text.find_first_not_of(" \t\r\n") == text.npos;
}

// Writes the text between the tags of an array, without the elements that describe the array.
void writeData(std::string_view content, MemoryFile& to)
{
	while (!content.empty())
	{
		const std::size_t tag = std::min(content.find('<'), content.size());
		to.append(content.substr(0, tag));
		content.remove_prefix(tag);
		if (const std::size_t length = text::lengthOfMarkup(content); !content.empty())
			content.remove_prefix(length > 0 ? length : content.size());
	}
}

void writeElement(const text::XmlElement& element, std::string_view text, MemoryFile& to)
{
	to.append(startTag(element) + ">");
	if (isArray(element))
	{
		writeData(contentOf(element, text), to);
		for (const text::XmlElement& child : element.children)
			writeElement(child, text, to);
	}
	else if (element.children.empty() && !isBlankText(element.text))
		to.append(escapedText(element.text));
	else
		for (const text::XmlElement& child : element.children)
			writeElement(child, text, to);
	to.append("</" + element.name + ">\n");
}

// A file that is open to be read.
class OpenFile
{
public:
	explicit OpenFile(const std::string& path) : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC))
	{
		if (file_ < 0)
			throw damaged("it cannot be opened again");
	}
	~OpenFile() { close(file_); }
	OpenFile(const OpenFile&) = delete;
	OpenFile& operator=(const OpenFile&) = delete;
	int get() const { return file_; }

private:
	int file_;
};

std::int64_t lastWhole(NumberType type, std::string_view bytes)
{
	const auto last = [&](auto number) -> std::int64_t
	{
		if (bytes.size() >= sizeof number)
			number = numberAt<decltype(number)>(bytes.data() + bytes.size() - sizeof number);
		return static_cast<std::int64_t>(number);
	};
	switch (type)
	{
	case NumberType::int32:
		return last(std::int32_t());
	case NumberType::uint32:
		return last(std::uint32_t());
	case NumberType::int64:
		return last(std::int64_t());
	case NumberType::uint64:
		return last(std::uint64_t());
	default:
		return -1;
	}
}

std::size_t bytesOfValue(const XmlArray& array)
{
	return array.type ? byteSize(*array.type) : 1;
}

bool isBits(const XmlArray& array)
{
	return array.element->attribute("type") == "Bit";
}

// Checks how many values so many bytes are. Arrays that do not hold numbers are not checked.
void checkBytes(const XmlArray& array, std::uint64_t bytes, std::int64_t last_offset)
{
	if (isBits(array) && array.values && bytes != (*array.values + 7) / 8)
		throw damaged(fmt::format("{} has {} bytes where {} bits belong", array.words, bytes, *array.values));
	if (!array.type)
		return;
	if (bytes % bytesOfValue(array) != 0)
		throw damaged(fmt::format("{} has {} bytes, which are no whole values", array.words, bytes));
	array.check(bytes / bytesOfValue(array), last_offset);
}

// Returns all bytes of an array, as little endian.
std::string unpacked(const XmlArray& array, int file, const text::XmlFile& given, const arrays::Packing& packing)
{
	std::string bytes;
	if (array.values == std::uint64_t(0))
		return bytes;
	try
	{
		const auto packed = openPacked(file, given, packing, *array.element);
		arrays::Scratch scratch;
		for (std::size_t p = 0; p < packed->partCount(); ++p)
		{
			const auto part = packed->part(p, packed->size(), scratch);
			bytes.append(reinterpret_cast<const char*>(part.data()), part.size());
		}
	}
	catch (const arrays::NotQuick&)
	{
		throw damaged(fmt::format("{} cannot be unpacked", array.words));
	}
	if (packing.is_big_endian)
		parts::swapNumbers(std::as_writable_bytes(std::span(bytes)), bytesOfValue(array));
	return bytes;
}

std::optional<arrays::Packing> packingIfKnown(const text::XmlElement& root)
{
	try
	{
		return packingOf(root);
	}
	catch (const arrays::NotQuick&)
	{
		return std::nullopt;
	}
}

// Returns true for an array of text that is not a list of numbers. Such text stays.
bool staysText(const XmlArray& array)
{
	return array.form == XmlArray::Form::text && !array.type;
}

// Writes elements whose arrays are appended, and remembers where to fill in their offsets.
class ElementsOfBytes
{
public:
	ElementsOfBytes(const std::vector<XmlArray>& arrays, std::string_view text, MemoryFile& to) : text_(text), to_(to)
	{
		for (std::size_t i = 0; i < arrays.size(); ++i)
			if (!staysText(arrays[i]))
				moved_[arrays[i].element] = i;
		places_.resize(arrays.size());
	}

	void write(const text::XmlElement& element)
	{
		const auto moved = moved_.find(&element);
		if (moved == moved_.end() && isArray(element))
			return writeElement(element, text_, to_);
		if (moved != moved_.end())
		{
			to_.append(startTag(element, {"format", "offset"}) + " format=\"appended\" offset=\"");
			places_[moved->second] = to_.size();
			to_.append(fmt::format("{:020}\">", 0));
		}
		else
			to_.append(startTag(element) + ">");
		if (element.children.empty() && moved == moved_.end() && !isBlankText(element.text))
			to_.append(escapedText(element.text));
		for (const text::XmlElement& child : element.children)
			write(child);
		to_.append("</" + element.name + ">\n");
	}

	void fillIn(std::size_t array, std::uint64_t offset) const
	{
		to_.overwrite(places_[array], fmt::format("{:020}", offset));
	}

private:
	std::map<const text::XmlElement*, std::size_t> moved_;
	std::vector<std::uint64_t> places_;
	std::string_view text_;
	MemoryFile& to_;
};

struct Found
{
	std::uint64_t bytes = 0;
	std::int64_t last = 0;
	bool is_strange = false;
};

// Reads the numbers of an array from text, and writes them to `to` unless it is null.
Found takeText(const XmlArray& array, std::string_view text, MemoryFile* to)
{
	const text::Numbers numbers =
	    text::readNumbers(contentOf(*array.element, text), *array.type, array.words, {.to = to, .is_xml = true});
	return {numbers.count * bytesOfValue(array), numbers.last, numbers.is_strange};
}

// Checks the length of base64 text, because VTK's reader does not report missing letters.
void checkLetters(const XmlArray& array, std::string_view content, std::uint64_t wanted)
{
	const std::size_t begin = std::min(content.find_first_not_of(" \t\r\n"), content.size());
	content = content.substr(begin, content.find('<', begin) - begin);
	std::uint64_t letters = 0;
	for (const char c : content)
		letters += static_cast<unsigned char>(c) > ' ';
	if (letters != wanted)
		throw damaged(fmt::format("{} has {} letters where {} belong", array.words, letters, wanted));
}

void checkAll(const std::vector<XmlArray>& arrays, const std::vector<std::optional<Found>>& found)
{
	for (std::size_t i = 0; i < arrays.size(); ++i)
	{
		const std::optional<std::size_t> offsets = arrays[i].offsets;
		if (found[i] && (!offsets || found[*offsets]))
			checkBytes(arrays[i], found[i]->bytes, offsets ? found[*offsets]->last : 0);
	}
}

} // namespace

void writeElements(const text::XmlFile& xml, std::string_view text, MemoryFile& to)
{
	to.append("<?xml version=\"1.0\"?>\n" + startTag(xml.root) + ">\n");
	for (const text::XmlElement& child : xml.root.children)
		if (child.name != "AppendedData")
			writeElement(child, text, to);
}

void writeAppendedStart(std::string_view encoding, MemoryFile& to)
{
	to.append(fmt::format("<AppendedData encoding=\"{}\">_", escapedText(encoding)));
}

void writeEnd(const text::XmlFile& xml, bool has_appended, MemoryFile& to)
{
	to.append(fmt::format("{}</{}>\n", has_appended ? "</AppendedData>" : "", xml.root.name));
	to.end();
}

void writeAsBytes(const std::string& path, const text::XmlFile& given, const text::XmlFile& xml,
                  const std::vector<XmlArray>& arrays, std::string_view text, MemoryFile& to)
{
	const bool has_bytes =
	    std::ranges::any_of(arrays, [](const XmlArray& array) { return array.form != XmlArray::Form::text; });
	const std::optional<arrays::Packing> packing = packingIfKnown(given.root);
	if (has_bytes && !packing)
		throw Refusal("an unknown compressor or byte order; save the file again, without compression");
	const OpenFile file(path);
	to.append("<?xml version=\"1.0\"?>\n" + startTag(xml.root, {"byte_order", "header_type", "compressor"}) +
	          " byte_order=\"LittleEndian\" header_type=\"UInt64\">\n");
	ElementsOfBytes elements(arrays, text, to);
	for (const text::XmlElement& child : xml.root.children)
		if (child.name != "AppendedData")
			elements.write(child);
	writeAppendedStart("raw", to);
	const std::uint64_t begin = to.size();
	std::vector<std::optional<Found>> found(arrays.size());
	for (std::size_t i = 0; i < arrays.size(); ++i)
	{
		if (staysText(arrays[i]))
			continue;
		const std::uint64_t head = to.size();
		std::uint64_t size = 0;
		to.append({reinterpret_cast<const char*>(&size), sizeof size});
		if (arrays[i].form == XmlArray::Form::text)
			found[i] = takeText(arrays[i], text, &to);
		else
		{
			const std::string bytes = unpacked(arrays[i], file.get(), given, *packing);
			to.append(bytes);
			found[i] = Found{bytes.size(), arrays[i].type ? lastWhole(*arrays[i].type, bytes) : 0};
		}
		size = found[i]->bytes;
		to.overwrite(head, {reinterpret_cast<const char*>(&size), sizeof size});
		elements.fillIn(i, head - begin);
	}
	checkAll(arrays, found);
	writeEnd(xml, true, to);
}

bool checkArrays(const std::string& path, const text::XmlFile& given, const std::vector<XmlArray>& arrays,
                 std::string_view text)
{
	std::vector<std::optional<Found>> found(arrays.size());
	bool is_strange = false;
	const OpenFile file(path);
	const std::optional<arrays::Packing> packing = packingIfKnown(given.root);
	arrays::Scratch scratch;
	for (std::size_t i = 0; i < arrays.size(); ++i)
	{
		const XmlArray& array = arrays[i];
		if (array.form == XmlArray::Form::text)
		{
			if (array.type)
				found[i] = takeText(array, text, nullptr);
			is_strange |= found[i] && found[i]->is_strange;
			continue;
		}
		if (array.values == std::uint64_t(0) || !packing)
			continue; // nothing is written for no values
		try
		{
			const auto packed = openPacked(file.get(), given, *packing, *array.element);
			if (array.form == XmlArray::Form::inline_bytes)
				checkLetters(array, contentOf(*array.element, text), packed->base64Letters());
			found[i] = Found{packed->size()};
			const bool gives_last =
			    std::ranges::any_of(arrays, [&](const XmlArray& each) { return each.offsets == i; }) && array.type &&
			    packed->size() % bytesOfValue(array) == 0;
			if (!gives_last || packed->partCount() == 0)
				continue;
			const auto part = packed->part(packed->partCount() - 1, packed->size(), scratch);
			std::string last(reinterpret_cast<const char*>(part.data()), part.size());
			last.erase(0, last.size() - std::min(last.size(), bytesOfValue(array)));
			if (packing->is_big_endian)
				parts::swapNumbers(std::as_writable_bytes(std::span(last)), bytesOfValue(array));
			found[i]->last = lastWhole(*array.type, last);
		}
		catch (const arrays::NotQuick&)
		{
			// For packed data, VTK's reader reports what is wrong, and it supports larger blocks.
			const bool is_known = array.values || (array.offsets && arrays[*array.offsets].values.value_or(0) > 0);
			if (packing->codec == arrays::Codec::none && is_known)
				throw damaged(fmt::format("{} is shorter than it should be", array.words));
			found[i].reset();
		}
	}
	checkAll(arrays, found);
	return !is_strange;
}

} // namespace vp::reader::quick
