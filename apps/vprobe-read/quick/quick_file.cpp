#include "quick_file.h"

#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/mapped_text.h"

#include <algorithm>

#include <fcntl.h>
#include <unistd.h>

using vp::grid::NumberType;

namespace
{

constexpr std::uint32_t kMaxComponents = 1 << 16;

} // namespace

Packing packingOf(const XmlElement& root)
{
	if (root.name != "VTKFile" || !isOneOf(root.attribute("byte_order"), {"LittleEndian", "BigEndian"}) ||
	    !isOneOf(root.attribute("version"), {"0.1", "1.0", "2.0", "2.1", "2.2", "2.3"}))
		throw NotQuick();
	Packing packing;
	packing.is_big_endian = root.attribute("byte_order") == "BigEndian";
	if (root.has("header_type"))
	{
		if (!isOneOf(root.attribute("header_type"), {"UInt32", "UInt64"}))
			throw NotQuick();
		packing.word_bytes = root.attribute("header_type") == "UInt64" ? 8 : 4;
	}
	const std::string_view compressor = root.attribute("compressor");
	if (compressor == "vtkZLibDataCompressor")
		packing.codec = Codec::zlib;
	else if (compressor == "vtkLZ4DataCompressor")
		packing.codec = Codec::lz4;
	else if (compressor == "vtkLZMADataCompressor")
		packing.codec = Codec::lzma;
	else if (root.has("compressor"))
		throw NotQuick();
	return packing;
}

QuickFile::QuickFile(const std::string& path)
{
	const MappedText mapped(path);
	std::optional<XmlFile> xml = parseXml(mapped.text());
	if (!xml)
		throw NotQuick();
	xml_ = std::move(*xml);
	packing_ = packingOf(xml_.root);
	if (packing_.is_big_endian)
		throw NotQuick();
	file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
	if (file_ < 0)
		throw NotQuick();
}

QuickFile::~QuickFile()
{
	if (file_ >= 0)
		close(file_);
}

const XmlElement& QuickFile::data() const
{
	for (const XmlElement& child : xml_.root.children)
		if (child.name != type() && child.name != "AppendedData")
			throw NotQuick();
	return onlyChild(xml_.root, type());
}

std::shared_ptr<const PackedArray> QuickFile::open(const XmlElement& array, std::uint64_t bytes) const
{
	auto packed = openPacked(file_, xml_, packing_, array);
	if (packed->size() != bytes)
		throw NotQuick();
	return packed;
}

std::shared_ptr<const PackedArray> openPacked(int file, const XmlFile& xml, const Packing& packing,
                                              const XmlElement& array)
{
	ByteSource source;
	if (array.attribute("format") == "appended" && isOneOf(xml.appended_encoding, {"raw", "base64"}))
		source = ByteSource(file, xml.appended_begin, xml.appended_end, xml.appended_encoding == "base64")
		             .from(numbersIn<std::uint64_t, 1>(array.attribute("offset"))[0]);
	else if (array.attribute("format") == "binary")
	{
		// White space stands about the letters.
		std::array<std::byte, 256> front;
		const std::uint64_t length = array.content_end - std::min(array.content_begin, array.content_end);
		const std::span<std::byte> read = std::span(front).first(std::min<std::uint64_t>(length, front.size()));
		Scratch scratch;
		ByteSource(file, array.content_begin, array.content_end, false).read(0, read, scratch);
		const auto letter = std::find_if(read.begin(), read.end(), [](std::byte b) { return b > std::byte(' '); });
		source = ByteSource(file, array.content_begin, array.content_end, true)
		             .from(static_cast<std::uint64_t>(letter - read.begin()));
	}
	else
		throw NotQuick();
	Scratch scratch;
	return std::make_shared<const PackedArray>(source, packing, scratch);
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

ArrayKind::ArrayKind(const XmlElement& array)
{
	const std::optional<NumberType> found = numberTypeOfXml(array.attribute("type"));
	if (array.name != "DataArray" || !found || array.has("TimeStep"))
		throw NotQuick();
	type = *found;
	components =
	    array.has("NumberOfComponents") ? numbersIn<std::uint32_t, 1>(array.attribute("NumberOfComponents"))[0] : 1;
	if (components < 1 || components > kMaxComponents)
		throw NotQuick();
}

const XmlElement& onlyChild(const XmlElement& parent, std::string_view name)
{
	const XmlElement* found = nullptr;
	for (const XmlElement& child : parent.children)
		if (child.name == name)
		{
			if (found)
				throw NotQuick();
			found = &child;
		}
	if (!found)
		throw NotQuick();
	return *found;
}
