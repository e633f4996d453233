#include "xdmf_document.h"

#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/hdf5/hdf5_parts.h"
#include "vprobe-read/hdf5/hdf5_stored.h"
#include "vprobe-read/text/text_cursor.h"

#include <vtkDataArray.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <hdf5.h>

namespace vp::reader::meshes
{

using grid::NumberType;

namespace
{

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxValues = std::uint64_t(1) << 40;
constexpr std::uint64_t kMaxComponents = 64;

std::string_view trimmed(std::string_view text)
{
	const auto is_blank = [](unsigned char c) { return std::isspace(c) != 0; };
	while (!text.empty() && is_blank(static_cast<unsigned char>(text.front())))
		text.remove_prefix(1);
	while (!text.empty() && is_blank(static_cast<unsigned char>(text.back())))
		text.remove_suffix(1);
	return text;
}

NumberType typeOf(std::string_view number, std::string_view precision)
{
	const int bytes = precision.empty() ? 4 : std::atoi(std::string(precision).c_str());
	if (number.empty() || number == "Float")
		return bytes == 8 ? NumberType::float64 : NumberType::float32;
	if (number == "Char")
		return NumberType::int8;
	if (number == "UChar")
		return NumberType::uint8;
	if (number == "Int" || number == "UInt")
	{
		const bool is_signed = number == "Int";
		switch (bytes)
		{
		case 1:
			return is_signed ? NumberType::int8 : NumberType::uint8;
		case 2:
			return is_signed ? NumberType::int16 : NumberType::uint16;
		case 8:
			return is_signed ? NumberType::int64 : NumberType::uint64;
		default:
			return is_signed ? NumberType::int32 : NumberType::uint32;
		}
	}
	throw Refusal(fmt::format("values of type {}, which are not read", number.substr(0, 20)));
}

arrays::ValueLayout flat(std::uint64_t count, NumberType type)
{
	// The layout's sides have 32 bits.
	arrays::ValueLayout layout;
	layout.type = type;
	layout.components = 1;
	layout.points = {static_cast<std::uint32_t>(count), 1, 1};
	if (count > ~std::uint32_t(0))
		throw Refusal("a DataItem of more than 4 thousand million values");
	return layout;
}

// Returns the values of an HDF5 data set, in the type that the XML gives.
std::string hdf5Bytes(const std::string& file, const std::string& path, std::uint64_t count, NumberType type)
{
	const std::string about = fmt::format("{}:{}", fs::path(file).filename().string(), path);
	const hdf5::Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
	if (opened < 0)
		throw Refusal(fmt::format("its data {} cannot be opened; keep the files together", about));
	const hdf5::Handle set = hdf5::openedSet(opened, path);
	const hdf5::Handle space(set < 0 ? -1 : H5Dget_space(set), H5Sclose);
	const hssize_t points = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
	if (points < 0)
		throw damaged(fmt::format("{} is missing", about));
	if (static_cast<std::uint64_t>(points) != count)
		throw damaged(fmt::format("{} has {} values where {} are wanted", about, points, count));
	// A set that was never written would read as zeros.
	H5D_space_status_t written = H5D_SPACE_STATUS_ERROR;
	if (H5Dget_space_status(set, &written) < 0 || (written == H5D_SPACE_STATUS_NOT_ALLOCATED && count > 0))
		throw damaged(fmt::format("{} was never written", about));
	hdf5::refuseMissingParts(set, about);
	std::string bytes(count * byteSize(type), '\0');
	if (H5Dread(set, hdf5::nativeType(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0)
		throw hdf5::unreadSet(set, about);
	return bytes;
}

} // namespace

std::uint64_t XdmfValues::count() const
{
	return static_cast<std::uint64_t>(array->GetNumberOfTuples());
}

std::vector<double> xdmfNumbers(std::string_view text)
{
	std::string words(text);
	std::replace(words.begin(), words.end(), ',', ' ');
	std::vector<double> numbers;
	for (text::Cursor at(words); !at.atEnd();)
		numbers.push_back(at.real());
	return numbers;
}

XdmfDocument::XdmfDocument(std::string file, std::string_view text) : file_(std::move(file)), text_(text)
{
	H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
	H5PLset_loading_state(0); // a file does not choose code to load
	// The usual document type names a file that nobody has.
	std::optional<text::XmlFile> xml = text::parseXml(text, text::DocumentType::internal);
	if (!xml || xml->root.name != "Xdmf")
		throw damaged("its XML cannot be parsed");
	xml_ = std::move(*xml);
	collectTakenOver(xml_.root);
}

std::string_view XdmfDocument::contents(const text::XmlElement& element) const
{
	if (element.is_from_entity)
		return trimmed(element.text);
	if (element.content_end < element.content_begin || element.content_end > text_.size())
		return {};
	const std::string_view given = text_.substr(element.content_begin, element.content_end - element.content_begin);
	if (given.find('&') == given.npos)
		return trimmed(given);
	// The parser keeps a long text only in a file with a document type.
	if (given.size() > text::kMaxShortText && element.text.empty())
		throw Refusal("a DataItem with an entity in more than 4096 letters");
	return trimmed(element.text);
}

// The attributes of a DataItem.
struct XdmfDocument::Item
{
	std::vector<std::uint64_t> sides;
	std::uint64_t count = 1;
	std::string_view number_type;
	NumberType type;
	std::string_view format;
	std::string_view text; // the values, or where they are
	std::uint64_t seek = 0;
	bool is_big_endian = false;

	// Returns the file and the data set in it, for HDF5.
	std::pair<std::string, std::string> fileAndSet() const
	{
		const auto colon = text.rfind(':');
		if (colon == text.npos)
			throw damaged("a DataItem that names no data set in a file");
		return {std::string(trimmed(text.substr(0, colon))), std::string(trimmed(text.substr(colon + 1)))};
	}
};

XdmfDocument::Item XdmfDocument::itemOf(const text::XmlElement& given) const
{
	const text::XmlElement& element = resolved(given);
	if (const auto kind = element.attribute("ItemType"); !kind.empty() && kind != "Uniform")
		throw Refusal(fmt::format("a DataItem of type {}, which is not read", kind.substr(0, 20)));
	Item item;
	for (const double side : xdmfNumbers(element.attribute("Dimensions")))
	{
		if (!(side >= 0.0) || side > 1e12 || (item.count *= static_cast<std::uint64_t>(side)) > kMaxValues)
			throw damaged("a DataItem of impossible Dimensions");
		item.sides.push_back(static_cast<std::uint64_t>(side));
	}
	if (item.sides.empty())
		throw damaged("a DataItem without Dimensions");
	item.number_type =
	    element.attribute("NumberType").empty() ? element.attribute("DataType") : element.attribute("NumberType");
	item.type = typeOf(item.number_type, element.attribute("Precision"));
	item.format = element.attribute("Format");
	item.text = contents(element);
	const auto seek = xdmfNumbers(element.attribute("Seek"));
	item.seek = seek.empty() || !(seek[0] >= 0.0) ? 0 : static_cast<std::uint64_t>(seek[0]);
	item.is_big_endian = element.attribute("Endian") == "Big";
	return item;
}

std::string XdmfDocument::pathOf(std::string_view name) const
{
	return (fs::path(file_).parent_path() / std::string(name)).string();
}

XdmfValues XdmfDocument::values(const text::XmlElement& element) const
{
	const Item item = itemOf(element);
	XdmfValues values;
	values.sides = item.sides;
	const arrays::ValueLayout layout = flat(item.count, item.type);
	if (item.format == "HDF")
	{
		const auto [file, set] = item.fileAndSet();
		values.array = arrays::arrayOf(hdf5Bytes(pathOf(file), set, item.count, item.type), layout, "");
	}
	else if (item.format == "Binary")
	{
		const MappedText file(pathOf(item.text));
		if (item.seek > file.text().size() || file.text().size() - item.seek < layout.byteCount())
			throw damaged(fmt::format("{} ends before its values do", item.text.substr(0, 80)));
		arrays::ValueLayout ordered = layout;
		ordered.is_big_endian = item.is_big_endian;
		values.array = arrays::arrayOf(file.text().substr(item.seek, layout.byteCount()), ordered, "");
	}
	else
	{
		// In text, so the type is that which holds them all.
		const bool whole = isOneOf(item.number_type, {"Int", "UInt", "Char", "UChar"});
		const arrays::ValueLayout own = flat(item.count, whole ? NumberType::int64 : NumberType::float64);
		if (item.count > item.text.size() / 2 + 1) // a digit and a blank each
			throw damaged("a DataItem of fewer values than its Dimensions say");
		std::string bytes(own.byteCount(), '\0');
		text::Cursor at(item.text);
		for (std::uint64_t i = 0; i < item.count; ++i)
		{
			if (whole)
				putNumber(at.integer(), bytes.data() + 8 * i);
			else
				putNumber(at.real(), bytes.data() + 8 * i);
		}
		if (!at.atEnd())
			throw damaged("a DataItem of more values than its Dimensions say");
		values.array = arrays::arrayOf(bytes, own, "");
	}
	return values;
}

vtkSmartPointer<vtkDataArray> XdmfDocument::storedValues(const text::XmlElement& element,
                                                         const std::array<std::uint32_t, 3>& points,
                                                         const std::string& name, const Request& request) const
{
	const Item item = itemOf(element);
	arrays::ValueLayout layout{points, 1, item.type, item.is_big_endian};
	const std::uint64_t tuples = layout.valueCount();
	const std::uint64_t components = tuples == 0 ? 0 : item.count / tuples;
	if (components < 1 || components > kMaxComponents || components * tuples != item.count)
		return nullptr;
	layout.components = static_cast<std::uint32_t>(components);
	if (!request.leaves(layout.byteCount()))
		return nullptr;
	std::optional<arrays::StoredPlace> place;
	if (item.format == "HDF")
	{
		const auto [file, set] = item.fileAndSet();
		const hdf5::Handle opened(H5Fopen(pathOf(file).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
		if (opened >= 0)
			place = hdf5::storedPlaceOf(opened, pathOf(file), set, layout, {});
	}
	else if (item.format == "Binary")
	{
		std::error_code error;
		const std::uint64_t size = fs::file_size(pathOf(item.text), error);
		if (!error && item.seek <= size && layout.byteCount() <= size - item.seek)
			place = arrays::storedRows(pathOf(item.text), item.seek, layout);
	}
	return place ? arrays::storedArray(layout, name, std::move(*place)) : nullptr;
}

} // namespace vp::reader::meshes
