#include "xdmf_document.h"

#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/hdf5/hdf5_parts.h"
#include "vprobe-read/text/text_cursor.h"

#include <vtkDataArray.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>

#include <hdf5.h>

using vp::grid::NumberType;

namespace
{

namespace fs = std::filesystem;

constexpr int kMaxReferences = 8;
constexpr std::uint64_t kMaxValues = std::uint64_t(1) << 40;

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

ValueLayout flat(std::uint64_t count, NumberType type)
{
	// The layout's sides have 32 bits.
	ValueLayout layout;
	layout.type = type;
	layout.components = 1;
	layout.points = {static_cast<std::uint32_t>(count), 1, 1};
	if (count > ~std::uint32_t(0))
		throw Refusal("a DataItem of more than 4 thousand million values");
	return layout;
}

// Of an HDF5 data set, in the type that the XML gives.
std::string hdf5Bytes(const std::string& file, const std::string& path, std::uint64_t count, NumberType type)
{
	const std::string about = fmt::format("{}:{}", fs::path(file).filename().string(), path);
	const Hdf5Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
	if (opened < 0)
		throw Refusal(fmt::format("its data {} cannot be opened; keep the files together", about));
	const Hdf5Handle set = openedSet(opened, path);
	const Hdf5Handle space(set < 0 ? -1 : H5Dget_space(set), H5Sclose);
	const hssize_t points = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
	if (points < 0)
		throw damaged(fmt::format("{} is missing", about));
	if (static_cast<std::uint64_t>(points) != count)
		throw damaged(fmt::format("{} has {} values where {} are wanted", about, points, count));
	// A set that was never written would read as zeros.
	H5D_space_status_t written = H5D_SPACE_STATUS_ERROR;
	if (H5Dget_space_status(set, &written) < 0 || (written == H5D_SPACE_STATUS_NOT_ALLOCATED && count > 0))
		throw damaged(fmt::format("{} was never written", about));
	refuseMissingParts(set, about);
	std::string bytes(count * byteSize(type), '\0');
	if (H5Dread(set, nativeType(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0)
		throw unreadSet(set, about);
	return bytes;
}

// "Name[3]" or "Name[@Name="x"]" of a path.
bool suits(const XmlElement& element, std::string_view step, int& skip)
{
	const auto bracket = step.find('[');
	if (element.name != step.substr(0, bracket))
		return false;
	if (bracket == step.npos)
		return true;
	const std::string_view inside = step.substr(bracket + 1, step.size() - bracket - 2);
	const auto quote = inside.find_first_of("\"'");
	if (inside.starts_with("@Name") && quote != inside.npos)
		return element.attribute("Name") == inside.substr(quote + 1, inside.size() - quote - 2);
	return --skip == 0;
}

// Writers choose the prefix of the namespace.
bool isInclude(const XmlElement& element)
{
	return element.name == "include" || element.name.ends_with(":include");
}

const XmlElement* gridNamed(const XmlElement& from, std::string_view name)
{
	for (const XmlElement& child : from.children)
	{
		if (child.name == "Grid" && child.attribute("Name") == name)
			return &child;
		if (const XmlElement* found = gridNamed(child, name))
			return found;
	}
	return nullptr;
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
	for (TextCursor at(words); !at.atEnd();)
		numbers.push_back(at.real());
	return numbers;
}

XdmfDocument::XdmfDocument(std::string file, std::string_view text) : file_(std::move(file)), text_(text)
{
	H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
	H5PLset_loading_state(0); // a file does not choose code to load
	// The usual document type names a file that nobody has.
	std::optional<XmlFile> xml = parseXml(text, DocumentType::internal);
	if (!xml || xml->root.name != "Xdmf")
		throw damaged("its XML cannot be parsed");
	xml_ = std::move(*xml);
	collectTakenOver(xml_.root);
}

std::string_view XdmfDocument::contents(const XmlElement& element) const
{
	if (element.is_from_entity)
		return trimmed(element.text);
	if (element.content_end < element.content_begin || element.content_end > text_.size())
		return {};
	const std::string_view given = text_.substr(element.content_begin, element.content_end - element.content_begin);
	if (given.find('&') == given.npos)
		return trimmed(given);
	// Of long ones, the parser keeps the text only in a file with a document type.
	if (given.size() > kMaxShortText && element.text.empty())
		throw Refusal("a DataItem with an entity in more than 4096 letters");
	return trimmed(element.text);
}

const XmlElement* XdmfDocument::atPath(std::string_view path) const
{
	const XmlElement* at = nullptr;
	while (!path.empty())
	{
		path.remove_prefix(1); // the slash
		std::size_t end = 0;
		bool quoted = false;
		for (; end < path.size() && (quoted || path[end] != '/'); ++end)
			quoted ^= path[end] == '"' || path[end] == '\'';
		const std::string_view step = path.substr(0, end);
		path.remove_prefix(end);
		const auto bracket = step.find('[');
		int skip = bracket == step.npos ? 1 : std::max(1, std::atoi(std::string(step.substr(bracket + 1)).c_str()));
		if (!at)
		{
			if (!suits(xml_.root, step, skip))
				return nullptr;
			at = &xml_.root;
			continue;
		}
		const auto found =
		    std::ranges::find_if(at->children, [&](const XmlElement& e) { return suits(e, step, skip); });
		if (found == at->children.end())
			return nullptr;
		at = &*found;
	}
	return at;
}

const XmlElement& XdmfDocument::resolved(const XmlElement& element) const
{
	const XmlElement* at = &element;
	for (int i = 0; i < kMaxReferences; ++i)
	{
		const std::string_view reference = at->attribute("Reference");
		if (reference.empty())
			return *at;
		const std::string_view path = reference == "XML" ? contents(*at) : reference;
		const XmlElement* next = path.starts_with('/') ? atPath(path) : nullptr;
		if (!next)
			throw Refusal(fmt::format("the reference {} leads nowhere", path.substr(0, 80)));
		at = next;
	}
	throw damaged("its references lead in a circle");
}

// As dolfin and meshio write: xpointer(//Grid[@Name="mesh"]/Grid[1]/*[self::Topology or self::Geometry]).
const XmlElement* XdmfDocument::includedGrid(const XmlElement& include) const
{
	const std::string_view pointer = include.attribute("xpointer");
	constexpr std::string_view start = "//Grid[@Name=";
	const auto at = pointer.find(start);
	const auto quote = at == pointer.npos ? at : at + start.size();
	const auto end = quote >= pointer.size() ? pointer.npos : pointer.find(pointer[quote], quote + 1);
	if (end == pointer.npos)
		throw Refusal(fmt::format("the reference {} is not understood", pointer.substr(0, 80)));
	const XmlElement* grid = gridNamed(xml_.root, pointer.substr(quote + 1, end - quote - 1));
	if (const auto inner = pointer.find("]/Grid", end); grid && inner != pointer.npos)
		grid = child(*grid, "Grid");
	return grid;
}

void XdmfDocument::collectTakenOver(const XmlElement& from)
{
	for (const XmlElement& element : from.children)
		if (!isInclude(element))
			collectTakenOver(element);
		else if (const XmlElement* grid = includedGrid(element))
			taken_over_.insert(grid);
}

bool XdmfDocument::isTakenOver(const XmlElement& grid) const
{
	return taken_over_.contains(&grid);
}

std::vector<const XmlElement*> XdmfDocument::children(const XmlElement& of, std::string_view name) const
{
	std::vector<const XmlElement*> found;
	for (const XmlElement& element : of.children)
	{
		if (element.name == name)
			found.push_back(&resolved(element));
		else if (isInclude(element) && element.attribute("xpointer").find(name) != std::string_view::npos &&
		         name != "Grid")
			if (const XmlElement* grid = includedGrid(element); grid && grid != &of)
				for (const XmlElement& taken : grid->children)
					if (taken.name == name)
						found.push_back(&resolved(taken));
	}
	return found;
}

const XmlElement* XdmfDocument::child(const XmlElement& of, std::string_view name) const
{
	const auto found = children(of, name);
	return found.empty() ? nullptr : found.front();
}

XdmfValues XdmfDocument::values(const XmlElement& given) const
{
	const XmlElement& item = resolved(given);
	if (const auto kind = item.attribute("ItemType"); !kind.empty() && kind != "Uniform")
		throw Refusal(fmt::format("a DataItem of type {}, which is not read", kind.substr(0, 20)));
	XdmfValues values;
	std::uint64_t count = 1;
	for (const double side : xdmfNumbers(item.attribute("Dimensions")))
	{
		if (!(side >= 0.0) || side > 1e12 || (count *= static_cast<std::uint64_t>(side)) > kMaxValues)
			throw damaged("a DataItem of impossible Dimensions");
		values.sides.push_back(static_cast<std::uint64_t>(side));
	}
	if (values.sides.empty())
		throw damaged("a DataItem without Dimensions");
	const auto given_type =
	    item.attribute("NumberType").empty() ? item.attribute("DataType") : item.attribute("NumberType");
	const ValueLayout layout = flat(count, typeOf(given_type, item.attribute("Precision")));
	const std::string_view format = item.attribute("Format");
	const std::string_view text = contents(item);
	if (format == "HDF")
	{
		const auto colon = text.rfind(':');
		if (colon == text.npos)
			throw damaged("a DataItem that names no data set in a file");
		const std::string file(trimmed(text.substr(0, colon)));
		values.array = arrayOf(hdf5Bytes((fs::path(file_).parent_path() / file).string(),
		                                 std::string(trimmed(text.substr(colon + 1))), count, layout.type),
		                       layout, "");
	}
	else if (format == "Binary")
	{
		const MappedText file((fs::path(file_).parent_path() / std::string(text)).string());
		const auto seek = xdmfNumbers(item.attribute("Seek"));
		const std::uint64_t skip = seek.empty() || !(seek[0] >= 0.0) ? 0 : static_cast<std::uint64_t>(seek[0]);
		if (skip > file.text().size() || file.text().size() - skip < layout.byteCount())
			throw damaged(fmt::format("{} ends before its values do", text.substr(0, 80)));
		ValueLayout ordered = layout;
		ordered.is_big_endian = item.attribute("Endian") == "Big";
		values.array = arrayOf(file.text().substr(skip, layout.byteCount()), ordered, "");
	}
	else
	{
		// In text, so the type is that which holds them all.
		const bool whole = isOneOf(given_type, {"Int", "UInt", "Char", "UChar"});
		const ValueLayout own = flat(count, whole ? NumberType::int64 : NumberType::float64);
		if (count > text.size() / 2 + 1) // a digit and a blank each
			throw damaged("a DataItem of fewer values than its Dimensions say");
		std::string bytes(own.byteCount(), '\0');
		TextCursor at(text);
		for (std::uint64_t i = 0; i < count; ++i)
		{
			const std::int64_t integer = whole ? at.integer() : 0;
			const double real = whole ? 0.0 : at.real();
			std::memcpy(bytes.data() + 8 * i, whole ? static_cast<const void*>(&integer) : &real, 8);
		}
		if (!at.atEnd())
			throw damaged("a DataItem of more values than its Dimensions say");
		values.array = arrayOf(bytes, own, "");
	}
	return values;
}
