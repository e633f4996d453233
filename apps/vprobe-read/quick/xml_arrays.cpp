#include "xml_arrays.h"

#include "base/real_text.h"
#include "quick_file.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

namespace vp::reader::quick
{

using grid::NumberType;

namespace
{

std::optional<NumberType> numberTypeOf(const text::XmlElement& array)
{
	return array.name == "DataArray" ? numberTypeOfXml(array.attribute("type")) : std::nullopt;
}

XmlArray::Form formOf(const text::XmlElement& array)
{
	const std::string_view format = array.attribute("format");
	if (format == "binary")
		return XmlArray::Form::inline_bytes;
	if (format == "ascii")
		return XmlArray::Form::text;
	return format == "appended" || array.has("offset") ? XmlArray::Form::appended : XmlArray::Form::text;
}

std::uint64_t sizeIn(const text::XmlElement& element, std::string_view attribute)
{
	if (!element.has(attribute))
		return 0;
	const std::int64_t count = text::Cursor(element.attribute(attribute)).integer();
	if (count < 0 || count >= std::int64_t(1) << 48)
		throw damaged(fmt::format("{} is {}", attribute, count));
	return static_cast<std::uint64_t>(count);
}

std::uint64_t componentsOf(const text::XmlElement& array)
{
	return array.has("NumberOfComponents") ? std::min<std::uint64_t>(sizeIn(array, "NumberOfComponents"), 1 << 16) : 1;
}

class ArrayLister
{
public:
	explicit ArrayLister(std::vector<XmlArray>& list) : list_(list) {}

	void addPiece(text::XmlElement& piece)
	{
		const std::optional<PieceSizes> sizes = sizesOfPiece(piece);
		for (text::XmlElement& section : piece.children)
			if (isOneOf(section.name, {"PointData", "CellData"}))
				addFields(section, sizes);
			else if (section.name == "Points")
				for (text::XmlElement& array : section.children)
					add(array, "the array of its points", sizes ? std::optional(3 * sizes->points) : std::nullopt);
			else if (section.name == "Coordinates")
				addAxes(section, sizes);
			else if (section.name == "Cells")
				addCells(section, sizeIn(piece, "NumberOfCells"));
			else if (isOneOf(section.name, {"Verts", "Lines", "Strips", "Polys"}))
				addCells(section, sizeIn(piece, "NumberOf" + section.name));
			else
				addOthers(section);
	}

	// Adds arrays that say themselves how many values they have, such as those of field data and of hyper tree grids.
	void addOthers(text::XmlElement& element)
	{
		for (text::XmlElement& child : element.children)
			if (isOneOf(child.name, {"DataArray", "Array"}))
			{
				std::optional<std::uint64_t> values;
				if (child.has("NumberOfTuples"))
					values = sizeIn(child, "NumberOfTuples") * componentsOf(child);
				add(child, fmt::format("the array {}", child.attribute("Name")), values);
			}
			else
				addOthers(child);
	}

private:
	XmlArray* add(text::XmlElement& element, std::string words, std::optional<std::uint64_t> values)
	{
		if (!isOneOf(element.name, {"DataArray", "Array"}))
			return nullptr;
		list_.push_back({&element, std::move(words), formOf(element), numberTypeOf(element), values, {}});
		return &list_.back();
	}

	void addFields(text::XmlElement& section, const std::optional<PieceSizes>& sizes)
	{
		const bool is_point = section.name == "PointData";
		for (text::XmlElement& array : section.children)
		{
			std::optional<std::uint64_t> values;
			if (sizes)
				values = (is_point ? sizes->points : sizes->cells) * componentsOf(array);
			add(array, fmt::format("the {} array {}", is_point ? "point" : "cell", array.attribute("Name")), values);
		}
	}

	void addAxes(text::XmlElement& section, const std::optional<PieceSizes>& sizes)
	{
		for (std::size_t axis = 0; axis < section.children.size(); ++axis)
		{
			std::optional<std::uint64_t> values;
			if (sizes && sizes->lattice && axis < 3)
				values = (*sizes->lattice)[axis];
			add(section.children[axis], fmt::format("the array of its coordinates {}", axis), values);
		}
	}

	void addCells(text::XmlElement& section, std::uint64_t cells)
	{
		std::optional<std::size_t> offsets, connectivity;
		for (text::XmlElement& array : section.children)
		{
			const std::string_view name = array.attribute("Name");
			std::optional<std::uint64_t> values;
			if (isOneOf(name, {"offsets", "types", "faceoffsets", "polyhedron_offsets"}))
				values = cells;
			const std::size_t place = list_.size();
			if (!add(array, fmt::format("the array {} of its cells", name), values))
				continue;
			if (name == "offsets")
				offsets = place;
			if (name == "connectivity")
				connectivity = place;
		}
		if (offsets && connectivity)
			list_[*connectivity].offsets = offsets;
	}

	std::vector<XmlArray>& list_;
};

// Returns true for sections of point or cell arrays, in a piece or in an index of pieces.
bool holdsFields(const text::XmlElement& section)
{
	return isOneOf(section.name, {"PointData", "CellData", "PPointData", "PCellData"});
}

std::string* attributeIn(text::XmlElement& element, std::string_view name)
{
	const auto found = std::ranges::find(element.attributes, name, [](const auto& each) { return each.first; });
	return found == element.attributes.end() ? nullptr : &found->second;
}

void nameArrays(text::XmlElement& section, std::set<std::string>& lines)
{
	std::set<std::string, std::less<>> names;
	for (const text::XmlElement& array : section.children)
		names.insert(std::string(array.attribute("Name")));
	std::set<std::string, std::less<>> taken;
	const auto ownName = [&](const std::string& stem, std::size_t number)
	{
		std::string name;
		do
			name = fmt::format("{} {}", stem, number++);
		while (names.contains(name) || taken.contains(name));
		return name;
	};
	const std::string_view kind = section.name.find("Point") != std::string::npos ? "point" : "cell";
	for (std::size_t i = 0; i < section.children.size(); ++i)
	{
		text::XmlElement& array = section.children[i];
		std::string name(array.attribute("Name"));
		if (name.empty())
		{
			name = ownName("array", i);
			if (std::string* given = attributeIn(array, "Name"))
				*given = name;
			else
				array.attributes.emplace_back("Name", name);
			lines.insert(fmt::format("a {} array without a name is called {}", kind, name));
		}
		else if (taken.contains(name))
		{
			const std::string own = ownName(name, 2);
			lines.insert(fmt::format("two {} arrays are called {}; the later one is shown as {}", kind, name, own));
			*attributeIn(array, "Name") = name = own;
		}
		taken.insert(name);
	}
}

bool hasStrangeNumber(const text::XmlElement& element)
{
	for (text::Cursor at(element.text); !at.atEnd();)
		if (const std::optional<double> number = parseReal(at.word()); number && !std::isfinite(*number))
			return true;
	return std::ranges::any_of(element.children, hasStrangeNumber);
}

struct NumbersOf
{
	std::string_view attribute;
	std::size_t count;
	bool is_whole;
};

constexpr NumbersOf kNumbersOf[] = {{"Origin", 3, false},
                                    {"Spacing", 3, false},
                                    {"Direction", 9, false},
                                    {"WholeExtent", 6, true},
                                    {"Extent", 6, true}};

template <class T>
bool isPlain(std::string_view word)
{
	T ignored = {};
	const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), ignored);
	return error == std::errc() && end == word.data() + word.size();
}

bool respell(text::XmlElement& element)
{
	bool is_new = false;
	for (const NumbersOf& numbers : kNumbersOf)
	{
		std::string* text = attributeIn(element, numbers.attribute);
		if (!text)
			continue;
		std::string plain;
		std::size_t there = 0;
		bool is_strange = false;
		for (text::Cursor at(*text); !at.atEnd(); ++there)
		{
			const std::string_view word = at.word();
			const std::optional<double> number = parseReal(word);
			if (!number || !std::isfinite(*number))
				throw damaged(
				    fmt::format("\"{}\" in its {} is no finite number", word.substr(0, 40), numbers.attribute));
			is_strange |= numbers.is_whole ? !isPlain<std::int64_t>(word) : !isPlain<double>(word);
			plain += fmt::format("{}{}", there > 0 ? " " : "", *number);
		}
		if (there != numbers.count)
			throw damaged(
			    fmt::format("its {} has {} numbers where {} belong", numbers.attribute, there, numbers.count));
		if (is_strange)
			*text = plain;
		is_new |= is_strange;
	}
	return is_new;
}

} // namespace

void XmlArray::check(std::uint64_t there, std::int64_t last_offset) const
{
	std::optional<std::uint64_t> wanted = values;
	if (offsets)
		wanted = static_cast<std::uint64_t>(std::max<std::int64_t>(last_offset, 0));
	if (wanted && *wanted != there)
		throw damaged(fmt::format("{} has {} values where {} belong", words, there, *wanted));
}

std::vector<XmlArray> arraysOfXml(text::XmlElement& data)
{
	std::vector<XmlArray> arrays;
	ArrayLister lister(arrays);
	for (text::XmlElement& child : data.children)
		if (child.name == "Piece")
			lister.addPiece(child);
		else
			lister.addOthers(child);
	return arrays;
}

std::optional<PieceSizes> sizesOfPiece(const text::XmlElement& piece)
{
	PieceSizes sizes;
	if (piece.has("NumberOfPoints"))
	{
		sizes.points = sizeIn(piece, "NumberOfPoints");
		for (const char* kind : {"NumberOfCells", "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys"})
			sizes.cells += sizeIn(piece, kind);
		return sizes;
	}
	if (!piece.has("Extent"))
		return std::nullopt;
	text::Cursor at(piece.attribute("Extent"));
	sizes.points = sizes.cells = 1;
	sizes.lattice.emplace();
	for (std::uint64_t& points : *sizes.lattice)
	{
		const std::int64_t low = at.integer();
		const std::int64_t high = at.integer();
		if (low < INT32_MIN || high > INT32_MAX || high < low)
			throw damaged(fmt::format("an extent from {} to {}", low, high));
		points = static_cast<std::uint64_t>(high - low) + 1;
		if (sizes.points >= std::uint64_t(1) << 48 || points > (std::uint64_t(1) << 48) / sizes.points)
			throw damaged("its extent is larger than there can be");
		sizes.points *= points;
		sizes.cells *= std::max<std::uint64_t>(points - 1, 1); // a flat lattice has cells of fewer dimensions
	}
	return sizes;
}

std::vector<std::string> giveOwnNames(text::XmlElement& data)
{
	std::set<std::string> lines;
	for (text::XmlElement& child : data.children)
		if (holdsFields(child))
			nameArrays(child, lines);
		else if (child.name == "Piece")
			for (text::XmlElement& section : child.children)
				if (holdsFields(section))
					nameArrays(section, lines);
	return {lines.begin(), lines.end()};
}

Fields fieldsOf(const text::XmlElement& piece)
{
	Fields fields;
	for (const text::XmlElement& section : piece.children)
		if (holdsFields(section))
			for (const text::XmlElement& array : section.children)
				fields[fmt::format("{} array {}", section.name.find("Point") != std::string::npos ? "point" : "cell",
				                   array.attribute("Name"))] =
				    fmt::format("{}, {} components", array.attribute("type"), componentsOf(array));
	return fields;
}

void refuseOtherFields(const text::XmlElement& data)
{
	std::optional<Fields> first;
	for (const text::XmlElement& child : data.children)
	{
		if (child.name != "Piece")
			continue;
		const Fields fields = fieldsOf(child);
		if (!first)
			first = fields;
		const auto other = std::ranges::mismatch(*first, fields);
		if (other.in1 == first->end() && other.in2 == fields.end())
			continue;
		const std::string& name = other.in1 != first->end() ? other.in1->first : other.in2->first;
		throw Refusal(fmt::format("its {} is not in all of its pieces, or of another type there; write the same arrays "
		                          "in each",
		                          name));
	}
}

bool leaveOutStrangeKeys(text::XmlElement& data)
{
	bool changes = std::erase_if(data.children, [](const text::XmlElement& child)
	                             { return child.name == "InformationKey" && hasStrangeNumber(child); }) > 0;
	for (text::XmlElement& child : data.children)
		changes |= leaveOutStrangeKeys(child);
	return changes;
}

bool respellAttributes(text::XmlElement& data)
{
	bool is_new = respell(data);
	for (text::XmlElement& child : data.children)
		if (child.name == "Piece")
			is_new |= respell(child);
	return is_new;
}

} // namespace vp::reader::quick
