// AVS UCD in text, by a parser of our own: VTK's makes up values where a file ends early.
#include "ucd_cells.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/own_name.h"
#include "vprobe-read/text/text_cursor.h"
#include "vprobe-read/text/text_end.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

namespace vp::reader::meshes
{

namespace
{

using Ids = std::unordered_map<std::int64_t, vtkIdType>;

void readCells(text::Cursor& at, std::size_t count, const Ids& points, vtkUnstructuredGrid* grid, Ids& cells)
{
	vtkNew<vtkIntArray> material;
	material->SetName("material");
	grid->Allocate(static_cast<vtkIdType>(count));
	for (std::size_t c = 0; c < count; ++c)
	{
		cells.emplace(at.integer(), static_cast<vtkIdType>(c));
		material->InsertNextValue(static_cast<int>(at.integer()));
		const std::string_view name = at.word();
		const auto kind = std::ranges::find(ucdCells(), name, &UcdCell::name);
		if (kind == ucdCells().end())
			throw Refusal(fmt::format("a cell of type \"{}\", which is not read", name.substr(0, 20)));
		std::array<vtkIdType, 8> corners = {};
		for (vtkIdType i = 0; i < kind->corners; ++i)
		{
			const auto found = points.find(at.integer());
			if (found == points.end())
				throw damaged(fmt::format("cell {} has a node that is not there", c));
			corners[static_cast<std::size_t>(i)] = found->second;
		}
		turnUcdCell(kind->type, corners);
		grid->InsertNextCell(kind->type, kind->corners, corners.data());
	}
	grid->GetCellData()->AddArray(material);
}

// How many arrays of how many components, a line with name and units for each, then a line of values for each point or
// cell.
void readArrays(text::Cursor& at, const Ids& ids, vtkDataSetAttributes* fields, const char* association,
                manifest::Writer& manifest)
{
	std::vector<vtkSmartPointer<vtkDoubleArray>> arrays(at.count(2));
	for (auto& array : arrays)
	{
		const std::int64_t components = at.integer();
		if (components < 1 || components > 64)
			throw damaged(fmt::format("an array of {} components", components));
		array = vtkSmartPointer<vtkDoubleArray>::New();
		array->SetNumberOfComponents(static_cast<int>(components));
	}
	at.line();
	for (const auto& array : arrays)
	{
		const std::string_view line = at.line();
		const auto comma = line.find(',');
		std::string_view units = comma == line.npos ? "" : line.substr(comma + 1);
		while (units.starts_with(' '))
			units.remove_prefix(1);
		array->SetName(std::string(line.substr(0, comma)).c_str());
		if (!units.empty() && units != "none" && units != "unknown")
			array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), std::string(units).c_str());
		array->SetNumberOfTuples(static_cast<vtkIdType>(ids.size()));
		array->Fill(std::numeric_limits<double>::quiet_NaN());
	}
	std::vector<bool> has_values(ids.size());
	for (std::size_t i = 0; i < ids.size(); ++i)
	{
		const auto found = ids.find(at.integer());
		if (found == ids.end())
			throw damaged("values of a node or cell that is not there");
		if (has_values[static_cast<std::size_t>(found->second)])
			throw damaged(fmt::format("{} {} has values twice", association, found->first));
		has_values[static_cast<std::size_t>(found->second)] = true;
		for (const auto& array : arrays)
			for (int c = 0; c < array->GetNumberOfComponents(); ++c)
				array->SetComponent(found->second, c, at.real());
	}
	for (const auto& array : arrays)
		manifest::addUnderOwnName(fields, array, association, manifest);
}

} // namespace

void readUcd(const Request& request, manifest::Writer& manifest)
{
	const MappedText file(request.file);
	text::Cursor at(file.text());
	while (at.peekLine().starts_with('#'))
		at.line();
	const std::size_t nodes = at.count(7);
	const std::size_t cells = at.count(6);
	const std::int64_t node_values = at.integer();
	const std::int64_t cell_values = at.integer();
	const std::int64_t model_values = at.integer();
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	Ids point_ids, cell_ids;
	for (std::size_t n = 0; n < nodes; ++n)
	{
		if (!point_ids.emplace(at.integer(), static_cast<vtkIdType>(n)).second)
			throw damaged("a node occurs twice");
		const double x = at.real();
		const double y = at.real();
		points->InsertNextPoint(x, y, at.real());
	}
	vtkNew<vtkUnstructuredGrid> grid;
	grid->SetPoints(points);
	readCells(at, cells, point_ids, grid, cell_ids);
	if (cell_ids.size() != cells)
		throw damaged("a cell occurs twice");
	if (node_values > 0)
		readArrays(at, point_ids, grid->GetPointData(), "point", manifest);
	if (cell_values > 0)
		readArrays(at, cell_ids, grid->GetCellData(), "cell", manifest);
	if (model_values == 0 && !at.atEnd())
		throw damaged(fmt::format("\"{}\" stands behind all that it announces", at.word().substr(0, 40)));
	if (text::endsInsideALine(request.file))
		manifest.warn(text::kCutTextWarning);
	manifest.add(grid);
}

} // namespace vp::reader::meshes
