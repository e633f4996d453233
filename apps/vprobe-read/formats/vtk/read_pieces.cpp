// Pieces of a parallel VTK XML file, each read as a block of its own.
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/read_files.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/xml_check.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/formats/vtk/piece_checks.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/quick/xml_arrays.h"
#include "vprobe-read/text/xml_tree.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

namespace vp::reader::vtk
{

namespace fs = std::filesystem;

namespace
{

// The head of a piece names its cells; arrays come behind it, or further pieces, which are then estimated.
constexpr std::size_t kHeadBytes = 1 << 16;
// The bytes of a cell with its arrays in a file, if the head tells nothing.
constexpr std::size_t kBytesOfCell = 50;

using Extent = std::array<int, 6>;

std::optional<Extent> extentOf(const char* text)
{
	Extent extent;
	const char* end = text ? text + std::string_view(text).size() : nullptr;
	for (int& number : extent)
	{
		while (text != end && *text == ' ')
			++text;
		const auto [next, error] = std::from_chars(text, end, number);
		if (text == end || error != std::errc())
			return std::nullopt;
		text = next;
	}
	return extent;
}

std::size_t cellsOf(const Extent& extent)
{
	std::size_t cells = 1;
	for (int axis = 0; axis < 3; ++axis)
		cells *= static_cast<std::size_t>(std::max(0, extent[2 * axis + 1] - extent[2 * axis]));
	return cells;
}

std::size_t pointsOf(const Extent& extent)
{
	std::size_t points = 1;
	for (int axis = 0; axis < 3; ++axis)
		points *= static_cast<std::size_t>(std::max(0, extent[2 * axis + 1] - extent[2 * axis])) + 1;
	return points;
}

std::string headOf(const std::string& file)
{
	std::string head(kHeadBytes, '\0');
	std::ifstream stream(file, std::ios::binary);
	stream.read(head.data(), static_cast<std::streamsize>(head.size()));
	head.resize(static_cast<std::size_t>(stream.gcount()));
	return head;
}

// The values of an attribute in a text, as numbers that are added up; none: nothing.
std::optional<std::size_t> sumOf(std::string_view text, std::string_view attribute)
{
	std::optional<std::size_t> sum;
	for (std::size_t at = text.find(attribute); at != text.npos; at = text.find(attribute, at))
	{
		at += attribute.size();
		std::size_t number = 0;
		if (std::from_chars(text.data() + at, text.data() + text.size(), number).ec == std::errc())
			sum = sum.value_or(0) + number;
	}
	return sum;
}

// The kind of lattice whose parts may be told from the whole's subscripts, or null.
const char* latticeKind(const std::string& type)
{
	return type == "PImageData"         ? "image"
	       : type == "PRectilinearGrid" ? "rectilinear"
	       : type == "PStructuredGrid"  ? "curvilinear"
	                                    : nullptr;
}

struct Piece
{
	std::string source; // as the index spells it
	std::string file;
	std::optional<Extent> extent;
};

std::vector<Piece> piecesOf(const Request& request, vtkXMLDataElement* whole)
{
	std::vector<Piece> pieces;
	for (int i = 0; i < whole->GetNumberOfNestedElements(); ++i)
	{
		vtkXMLDataElement* element = whole->GetNestedElement(i);
		const char* source = element->GetAttribute("Source");
		if (std::string_view(element->GetName() ? element->GetName() : "") != "Piece")
			continue;
		if (!source)
			refusePieceWithoutFile();
		const fs::path file = fs::path(request.file).parent_path() / source;
		if (!fs::is_regular_file(file))
			throw Refusal(fmt::format("its piece {} cannot be opened; keep them together", file.string()));
		pieces.push_back({source, file.string(), extentOf(element->GetAttribute("Extent"))});
	}
	for (const Piece& piece : pieces)
		noteFile(piece.file.c_str()); // whether or not it is read: no output may take its place
	return pieces;
}

// The arrays of an index, or of a file's first piece; none where there is no piece, or none can be told.
std::optional<quick::Fields> fieldsOfFile(const std::string& file, bool is_index)
{
	const MappedText mapped(file);
	const std::optional<text::XmlFile> xml = text::parseXml(mapped.text());
	if (!xml)
		return std::nullopt;
	const auto data = std::ranges::find(xml->root.children, xml->root.attribute("type"), &text::XmlElement::name);
	if (data == xml->root.children.end())
		return std::nullopt;
	if (is_index)
		return quick::fieldsOf(*data);
	const auto piece = std::ranges::find(data->children, "Piece", &text::XmlElement::name);
	return piece == data->children.end() ? std::nullopt : std::optional(quick::fieldsOf(*piece));
}

void refuseOtherPiece(const Piece& piece, const std::string& type, const std::optional<quick::Fields>& of_index)
{
	refuseOtherKind(type, formats::xmlTypeOfFile(piece.file), piece.source);
	const std::optional<quick::Fields> of_piece = of_index ? fieldsOfFile(piece.file, false) : std::nullopt;
	if (of_piece && cellsOfXml(piece.file) > 0) // others have no arrays to give
		refuseMissingFields(*of_index, *of_piece, piece.source);
}

// Pieces that lie on each other have cells twice, which only the whole's reader parts.
bool areApart(const std::vector<Piece>& pieces)
{
	const auto meet = [](const Extent& a, const Extent& b)
	{
		for (int axis = 0; axis < 3; ++axis)
			if (std::min(a[2 * axis + 1], b[2 * axis + 1]) <= std::max(a[2 * axis], b[2 * axis]))
				return false;
		return true;
	};
	for (std::size_t i = 0; i < pieces.size(); ++i)
		for (std::size_t j = 0; j < i; ++j)
			if (meet(*pieces[i].extent, *pieces[j].extent))
				return false;
	return true;
}

// Adds a piece of an image, with the places that its points have in the whole, to the last bit.
void addImagePiece(const Request& request, const Extent& whole, manifest::Writer& manifest)
{
	const auto data = loadXml(request, formats::xmlTypeOfFile(request.file), manifest);
	auto* image = vtkImageData::SafeDownCast(data);
	if (!image)
		throw damaged(fmt::format("{} is no image", request.file));
	manifest.addImageOf(image, {whole[0], whole[2], whole[4]});
}

} // namespace

std::size_t cellsOfXml(const std::string& file)
{
	const std::string head = headOf(file);
	if (const std::optional<std::size_t> cells = sumOf(head, " NumberOfCells=\""))
		return *cells;
	const std::string_view extent = " WholeExtent=\"";
	if (const std::size_t at = head.find(extent); at != head.npos)
	{
		const std::size_t begin = at + extent.size();
		const std::string text = head.substr(begin, head.find('"', begin) - begin);
		if (const std::optional<Extent> whole = extentOf(text.c_str()))
			return cellsOf(*whole);
	}
	std::error_code ignored;
	return static_cast<std::size_t>(fs::file_size(file, ignored)) / kBytesOfCell;
}

bool readPieces(const Request& request, const std::string& type, manifest::Writer& manifest)
{
	const char* kind = latticeKind(type);
	if (!manifest.parts().filters() || manifest.parts().isInside() || (type != "PUnstructuredGrid" && !kind))
		return false;
	if (manifest.parts().lists()) // each chosen one is looked at as it is read
		checks::refuseShortXml(request.file);
	else
		checks::refuseDeepXml(request.file);
	const auto root =
	    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(request.file.c_str()));
	vtkXMLDataElement* whole = root ? root->FindNestedElementWithName(type.c_str()) : nullptr;
	if (!whole)
		throw damaged(fmt::format("it has no {} element", type));
	const std::vector<Piece> pieces = piecesOf(request, whole);
	const std::optional<quick::Fields> of_index = fieldsOfFile(request.file, true);
	const std::optional<Extent> extent = extentOf(whole->GetAttribute("WholeExtent"));
	if (kind)
	{
		const bool is_known = extent && std::ranges::all_of(pieces, [](const Piece& piece) { return !!piece.extent; });
		if (!is_known || !areApart(pieces))
			return false;
		manifest.parts().beginBlock({{"kind", kind}, {"points", pointsOf(*extent)}});
	}
	else
		manifest.parts().beginBlock({{"kind", "unstructured"}, {"points", 0u}});
	for (std::size_t i = 0; i < pieces.size(); ++i)
	{
		const Piece& piece = pieces[i];
		// If parts are chosen, nobody asks how large the others are.
		const std::size_t cells = piece.extent               ? cellsOf(*piece.extent)
		                          : manifest.parts().lists() ? cellsOfXml(piece.file)
		                                                     : 0;
		if (!manifest.parts().begin(cells))
			continue;
		const InsidePart inside(manifest.parts());
		refuseOtherPiece(piece, type, of_index);
		Request of_piece = request;
		of_piece.file = piece.file;
		of_piece.format.clear();
		manifest.setPrefix(fmt::format("piece {}", i));
		if (type == "PImageData")
			addImagePiece(of_piece, *extent, manifest);
		else
			addXml(of_piece, formats::xmlTypeOfFile(of_piece.file), manifest);
	}
	manifest.parts().endBlock();
	return true;
}

} // namespace vp::reader::vtk
