// AVS UCD in binary, by a parser of our own: VTK's overwrites its memory for arrays of more than three components, and
// reads past its lists where the cells say more corners than they have.
#include "ucd_cells.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/own_name.h"
#include "vprobe-read/text/text_cursor.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <vector>

namespace vp::reader::meshes
{

namespace
{

constexpr std::size_t kUcdNameBytes = 1024; // all names, or all units, of the arrays of points or cells

struct UcdCounts
{
	std::uint32_t nodes, cells, node_values, cell_values, model_values, corners;

	std::uint64_t bytes() const
	{
		const auto data = [](std::uint64_t values, std::uint64_t tuples)
		{ return values == 0 ? 0 : 2 * kUcdNameBytes + 4 + values * (16 + 4 * tuples); };
		return 25 + std::uint64_t(16) * cells + std::uint64_t(4) * corners + std::uint64_t(12) * nodes +
		       data(node_values, nodes) + data(cell_values, cells) + data(model_values, 1);
	}
};

UcdCounts readUcdCounts(text::Cursor& at, ByteOrder order)
{
	at.setOrder(order);
	at.moveTo(1); // behind the 7 that says binary
	UcdCounts counts;
	for (std::uint32_t* count : {&counts.nodes, &counts.cells, &counts.node_values, &counts.cell_values,
	                             &counts.model_values, &counts.corners})
		*count = at.binary<std::uint32_t>();
	return counts;
}

void readBinaryUcdCells(text::Cursor& at, const UcdCounts& counts, vtkUnstructuredGrid* grid)
{
	struct Head
	{
		std::int32_t material, corners, kind;
	};
	std::vector<Head> heads(counts.cells);
	for (Head& head : heads)
	{
		at.binary<std::int32_t>(); // its number
		head.material = at.binary<std::int32_t>();
		head.corners = at.binary<std::int32_t>();
		head.kind = at.binary<std::int32_t>();
	}
	vtkNew<vtkIntArray> material;
	material->SetName("material");
	grid->Allocate(static_cast<vtkIdType>(counts.cells));
	const auto kinds = ucdCells();
	std::uint64_t used = 0;
	for (const Head& head : heads)
	{
		if (head.kind < 0 || static_cast<std::size_t>(head.kind) >= kinds.size() ||
		    head.corners != kinds[static_cast<std::size_t>(head.kind)].corners)
			throw damaged(fmt::format("a cell of kind {} with {} corners", head.kind, head.corners));
		if ((used += static_cast<std::uint64_t>(head.corners)) > counts.corners)
			throw damaged("its cells have more corners than its list");
		std::array<vtkIdType, 8> corners = {};
		for (int i = 0; i < head.corners; ++i)
		{
			const auto node = at.binary<std::uint32_t>();
			if (node < 1 || node > counts.nodes)
				throw damaged("a cell has a node that is not there");
			corners[static_cast<std::size_t>(i)] = node - 1;
		}
		const UcdCell& kind = kinds[static_cast<std::size_t>(head.kind)];
		turnUcdCell(kind.type, corners);
		grid->InsertNextCell(kind.type, kind.corners, corners.data());
		material->InsertNextValue(head.material);
	}
	if (used != counts.corners)
		throw damaged("its list has more corners than its cells");
	grid->GetCellData()->AddArray(material);
}

// All of x, then of y and z.
void readBinaryUcdPoints(text::Cursor& at, const UcdCounts& counts, vtkUnstructuredGrid* grid)
{
	vtkNew<vtkFloatArray> places;
	places->SetNumberOfComponents(3);
	places->SetNumberOfTuples(counts.nodes);
	for (int axis = 0; axis < 3; ++axis)
		for (vtkIdType n = 0; n < static_cast<vtkIdType>(counts.nodes); ++n)
			places->SetTypedComponent(n, axis, at.binary<float>());
	vtkNew<vtkPoints> points;
	points->SetData(places);
	grid->SetPoints(points);
}

// Names or units, each ended by a period.
std::vector<std::string> readUcdNames(text::Cursor& at)
{
	std::string text;
	for (std::size_t i = 0; i < kUcdNameBytes; ++i)
		text += at.binary<char>();
	text.resize(std::min(text.find('\0'), text.size()));
	std::vector<std::string> names;
	for (std::size_t start = 0, end; (end = text.find('.', start)) != text.npos; start = end + 1)
		names.push_back(text.substr(start, end - start));
	return names;
}

void readBinaryUcdArrays(text::Cursor& at, std::uint32_t values, vtkIdType tuples, vtkDataSetAttributes* fields,
                         const char* association, manifest::Writer& manifest)
{
	const std::vector<std::string> names = readUcdNames(at);
	const std::vector<std::string> units = readUcdNames(at);
	const auto arrays = at.binary<std::uint32_t>();
	if (arrays > values)
		throw damaged(fmt::format("{} arrays of {} values", arrays, values));
	std::vector<std::uint32_t> components(values);
	for (std::uint32_t& count : components)
		count = at.binary<std::uint32_t>();
	at.moveTo(at.place() + std::size_t(8) * values); // the least and the greatest values
	std::uint32_t left = values;
	for (std::uint32_t a = 0; a < arrays; ++a)
	{
		if (components[a] < 1 || components[a] > left || components[a] > 64)
			throw damaged(fmt::format("an array of {} components", components[a]));
		left -= components[a];
		vtkNew<vtkFloatArray> array;
		array->SetName((a < names.size() ? names[a] : fmt::format("array {}", a)).c_str());
		if (a < units.size() && !units[a].empty() && units[a] != "none")
			array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), units[a].c_str());
		array->SetNumberOfComponents(static_cast<int>(components[a]));
		array->SetNumberOfTuples(tuples);
		for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
			array->SetValue(i, at.binary<float>());
		manifest::addUnderOwnName(fields, array, association, manifest);
	}
	if (left != 0)
		throw damaged("its arrays have fewer components than it announces");
	at.moveTo(at.place() + std::size_t(4) * values); // which are active
}

} // namespace

void readUcdBinary(const Request& request, manifest::Writer& manifest)
{
	const MappedText file(request.file);
	text::Cursor at(file.text());
	// The size tells the order of bytes, and that all is there.
	UcdCounts counts = readUcdCounts(at, ByteOrder::big);
	if (counts.bytes() != file.text().size())
		counts = readUcdCounts(at, ByteOrder::little);
	if (counts.bytes() != file.text().size())
		throw damaged(fmt::format("{} bytes where its header asks for {}", file.text().size(), counts.bytes()));
	vtkNew<vtkUnstructuredGrid> grid;
	readBinaryUcdCells(at, counts, grid);
	readBinaryUcdPoints(at, counts, grid);
	if (counts.node_values > 0)
		readBinaryUcdArrays(at, counts.node_values, counts.nodes, grid->GetPointData(), "point", manifest);
	if (counts.cell_values > 0)
		readBinaryUcdArrays(at, counts.cell_values, counts.cells, grid->GetCellData(), "cell", manifest);
	manifest.add(grid);
}

} // namespace vp::reader::meshes
