#include "quick_file.h"

#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/mapped_text.h"

#include <algorithm>

#include <fcntl.h>
#include <unistd.h>

namespace vp::reader::quick
{

using grid::NumberType;

namespace
{

constexpr std::uint32_t kMaxComponents = 1 << 16;

} // namespace

arrays::Packing packingOf(const text::XmlElement& root)
{
	if (root.name != "VTKFile" || !isOneOf(root.attribute("byte_order"), {"LittleEndian", "BigEndian"}) ||
	    !isOneOf(root.attribute("version"), {"0.1", "1.0", "2.0", "2.1", "2.2", "2.3"}))
		throw arrays::NotQuick();
	arrays::Packing packing;
	packing.is_big_endian = root.attribute("byte_order") == "BigEndian";
	if (root.has("header_type"))
	{
		if (!isOneOf(root.attribute("header_type"), {"UInt32", "UInt64"}))
			throw arrays::NotQuick();
		packing.word_bytes = root.attribute("header_type") == "UInt64" ? 8 : 4;
	}
	const std::string_view compressor = root.attribute("compressor");
	if (compressor == "vtkZLibDataCompressor")
		packing.codec = arrays::Codec::zlib;
	else if (compressor == "vtkLZ4DataCompressor")
		packing.codec = arrays::Codec::lz4;
	else if (compressor == "vtkLZMADataCompressor")
		packing.codec = arrays::Codec::lzma;
	else if (root.has("compressor"))
		throw arrays::NotQuick();
	return packing;
}

File::File(const std::string& path)
{
	const MappedText mapped(path);
	std::optional<text::XmlFile> xml = text::parseXml(mapped.text());
	if (!xml)
		throw arrays::NotQuick();
	xml_ = std::move(*xml);
	packing_ = packingOf(xml_.root);
	if (packing_.is_big_endian)
		throw arrays::NotQuick();
	file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
	if (file_ < 0)
		throw arrays::NotQuick();
}

File::~File()
{
	if (file_ >= 0)
		close(file_);
}

const text::XmlElement& File::data() const
{
	for (const text::XmlElement& child : xml_.root.children)
		if (child.name != type() && child.name != "AppendedData")
			throw arrays::NotQuick();
	return onlyChild(xml_.root, type());
}

std::shared_ptr<const arrays::PackedArray> File::open(const text::XmlElement& array, std::uint64_t bytes) const
{
	auto packed = openPacked(file_, xml_, packing_, array);
	if (packed->size() != bytes)
		throw arrays::NotQuick();
	return packed;
}

std::shared_ptr<const arrays::PackedArray> openPacked(int file, const text::XmlFile& xml,
                                                      const arrays::Packing& packing, const text::XmlElement& array)
{
	arrays::ByteSource source;
	if (array.attribute("format") == "appended" && isOneOf(xml.appended_encoding, {"raw", "base64"}))
		source = arrays::ByteSource(file, xml.appended_begin, xml.appended_end, xml.appended_encoding == "base64")
		             .from(numbersIn<std::uint64_t, 1>(array.attribute("offset"))[0]);
	else if (array.attribute("format") == "binary")
	{
		// White space stands about the letters.
		std::array<std::byte, 256> front;
		const std::uint64_t length = array.content_end - std::min(array.content_begin, array.content_end);
		const std::span<std::byte> read = std::span(front).first(std::min<std::uint64_t>(length, front.size()));
		arrays::Scratch scratch;
		arrays::ByteSource(file, array.content_begin, array.content_end, false).read(0, read, scratch);
		const auto letter = std::find_if(read.begin(), read.end(), [](std::byte b) { return b > std::byte(' '); });
		source = arrays::ByteSource(file, array.content_begin, array.content_end, true)
		             .from(static_cast<std::uint64_t>(letter - read.begin()));
	}
	else
		throw arrays::NotQuick();
	arrays::Scratch scratch;
	return std::make_shared<const arrays::PackedArray>(source, packing, scratch);
}

std::optional<NumberType> numberTypeOfXml(std::string_view word)
{
	constexpr std::array<std::pair<std::string_view, NumberType>, 10> types = {{{"Int8", NumberType::int8},
	                                                                            {"UInt8", NumberType::uint8},
	                                                                            {"Int16", NumberType::int16},
	                                                                            {"UInt16", NumberType::uint16},
	                                                                            {"Int32", NumberType::int32},
	                                                                            {"UInt32", NumberType::uint32},
	                                                                            {"Int64", NumberType::int64},
	                                                                            {"UInt64", NumberType::uint64},
	                                                                            {"Float32", NumberType::float32},
	                                                                            {"Float64", NumberType::float64}}};
	const auto found = std::find_if(types.begin(), types.end(), [&](const auto& each) { return each.first == word; });
	return found == types.end() ? std::nullopt : std::optional(found->second);
}

ArrayKind::ArrayKind(const text::XmlElement& array)
{
	const std::optional<NumberType> found = numberTypeOfXml(array.attribute("type"));
	if (array.name != "DataArray" || !found || array.has("TimeStep"))
		throw arrays::NotQuick();
	type = *found;
	components =
	    array.has("NumberOfComponents") ? numbersIn<std::uint32_t, 1>(array.attribute("NumberOfComponents"))[0] : 1;
	if (components < 1 || components > kMaxComponents)
		throw arrays::NotQuick();
}

const text::XmlElement& onlyChild(const text::XmlElement& parent, std::string_view name)
{
	const text::XmlElement* found = nullptr;
	for (const text::XmlElement& child : parent.children)
		if (child.name == name)
		{
			if (found)
				throw arrays::NotQuick();
			found = &child;
		}
	if (!found)
		throw arrays::NotQuick();
	return *found;
}

} // namespace vp::reader::quick
