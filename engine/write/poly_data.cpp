#include "write/poly_data.h"

#include "write/xml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vp::write
{

namespace
{

static_assert(std::endian::native == std::endian::little, "the head says little endian");

// Padded to 20 characters, as VTK's writer does: files stay equal byte by byte to those of earlier versions.
template <class Value>
std::string attribute(std::string_view name, const Value& value)
{
	const std::string text = fmt::format("{}", value);
	return fmt::format(" {}=\"{}\"{:{}}", name, text, "", std::max<std::size_t>(text.size(), 20) - text.size());
}

const char* xmlType(std::optional<grid::NumberType> type)
{
	if (!type)
		return "String";
	constexpr const char* names[] = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
	                                 "UInt32", "Int64", "UInt64", "Float32", "Float64"};
	return names[static_cast<int>(*type)];
}

// The words of the head about arrays at one place of the file.
struct Wording
{
	int indent;
	bool tells_tuples; // elsewhere they follow from the numbers of points and cells
	bool tells_range;
};
constexpr Wording kFileArray{6, true, true};
constexpr Wording kPieceArray{8, false, true};
constexpr Wording kCellList{8, false, false};

std::string rangeText(const XmlArray& array, bool is_told)
{
	if (!array.type)
		return {};
	const auto range = is_told ? valueRange(array) : std::nullopt;
	const auto number = [](double value) { return fmt::format("{:.11g}", value); };
	return attribute("RangeMin", range ? number(range->first) : "") +
	       attribute("RangeMax", range ? number(range->second) : "");
}

// The size of every array is known, so the head with its offsets can be written before the data.
class AppendedArrays
{
public:
	// Gives the array's line of the head.
	std::string add(const XmlArray& array, const Wording& wording)
	{
		std::string line = fmt::format("{:{}}<{} type=\"{}\" Name=\"{}\"", "", wording.indent,
		                               array.type ? "DataArray" : "Array", xmlType(array.type), array.name);
		if (array.components > 1)
			line += fmt::format(" NumberOfComponents=\"{}\"", array.components);
		if (wording.tells_tuples)
			line += fmt::format(" NumberOfTuples=\"{}\"", array.tuples());
		line += " format=\"appended\"" + rangeText(array, wording.tells_range) + attribute("offset", offset_) + "/>\n";
		offset_ += sizeof(std::uint64_t) + array.bytes.size();
		parts_.push_back(array.bytes);
		return line;
	}

	void write(AtomicFile& file) const
	{
		for (const std::span<const std::byte> part : parts_)
		{
			const std::uint64_t bytes = part.size();
			file.write({reinterpret_cast<const char*>(&bytes), sizeof(bytes)});
			file.write({reinterpret_cast<const char*>(part.data()), part.size()});
		}
	}

private:
	std::vector<std::span<const std::byte>> parts_;
	std::uint64_t offset_ = 0;
};

std::string attributeSet(const char* element, const XmlArrays& arrays, AppendedArrays& appended)
{
	std::string text = fmt::format("      <{}>\n", element);
	for (const XmlArray& array : arrays)
		text += appended.add(array, kPieceArray);
	return text + fmt::format("      </{}>\n", element);
}

std::string cellSet(const char* element, const XmlCells& cells, AppendedArrays& appended)
{
	// The file leaves out the first start, which is 0.
	const auto ends = cells.starts.subspan(cells.starts.empty() ? 0 : 1);
	std::string text = fmt::format("      <{}>\n", element);
	for (const XmlArray& array : {xmlArray("connectivity", grid::NumberType::int64, 1, cells.ids),
	                              xmlArray("offsets", grid::NumberType::int64, 1, ends)})
		text += appended.add(array, kCellList);
	return text + fmt::format("      </{}>\n", element);
}

} // namespace

void writePolyData(const PolyData& data, AtomicFile& file)
{
	AppendedArrays appended;
	std::string head =
	    "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
	    "  <PolyData>\n";
	if (!data.file_arrays.empty())
	{
		head += "    <FieldData>\n";
		for (const XmlArray& array : data.file_arrays)
			head += appended.add(array, kFileArray);
		head += "    </FieldData>\n";
	}
	head += "    <Piece" + attribute("NumberOfPoints", data.points.size()) +
	        attribute("NumberOfVerts", data.dots.count()) + attribute("NumberOfLines", data.lines.count()) +
	        attribute("NumberOfStrips", 0) + attribute("NumberOfPolys", data.polygons.count()) + ">\n";
	head += attributeSet("PointData", data.point_arrays, appended);
	head += attributeSet("CellData", data.cell_arrays, appended);
	XmlArrays points;
	points.add(xmlArray("Points", grid::NumberType::float64, 3, data.points));
	head += attributeSet("Points", points, appended);
	head += cellSet("Verts", data.dots, appended);
	head += cellSet("Lines", data.lines, appended);
	head += cellSet("Strips", {}, appended);
	head += cellSet("Polys", data.polygons, appended);
	head += "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n   _";

	file.write(head);
	appended.write(file);
	file.write("\n  </AppendedData>\n</VTKFile>\n");
}

namespace
{

std::string indexSet(const char* element, const XmlArrays& arrays)
{
	std::string text = fmt::format("    <{}>\n", element);
	for (const XmlArray& array : arrays)
		text += fmt::format("      <PDataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"/>\n",
		                    xmlType(array.type), array.name, array.components);
	return text + fmt::format("    </{}>\n", element);
}

} // namespace

void writePolyDataIndex(const PolyData& like, std::span<const std::string> parts, AtomicFile& file)
{
	XmlArrays points;
	points.add(xmlArray("Points", grid::NumberType::float64, 3, like.points));
	std::string text =
	    "<VTKFile type=\"PPolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
	    "  <PPolyData GhostLevel=\"0\">\n";
	text += indexSet("PPointData", like.point_arrays);
	text += indexSet("PCellData", like.cell_arrays);
	text += indexSet("PPoints", points);
	for (const std::string& part : parts)
		text += fmt::format("    <Piece Source=\"{}\"/>\n", xmlText(part));
	file.write(text + "  </PPolyData>\n</VTKFile>\n");
}

} // namespace vp::write
