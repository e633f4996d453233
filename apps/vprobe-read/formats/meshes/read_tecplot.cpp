// Tecplot text files by a parser of our own: VTK's makes up zeros where a file ends early, and knows no shared values.
#include "tecplot_file.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/cells_by_faces.h"
#include "vprobe-read/cells/grown_cells.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"
#include "vprobe-read/text/text_end.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace vp::reader::meshes
{

namespace
{

// The axis that a variable's name means: "X", "y [m]", "CoordinateZ"; 3 for other names.
std::size_t axisOf(const std::string& variable)
{
	std::string name = variable.substr(0, variable.find_first_of(" [(,"));
	std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
	for (std::size_t axis = 0; axis < 3; ++axis)
		if (name == std::string(1, static_cast<char>('x' + axis)) || name == fmt::format("coordinate{}", "xyz"[axis]))
			return axis;
	return 3;
}

// The variables that place the points: by their names, else the first ones that place nothing else.
std::array<std::size_t, 3> placesOf(const std::vector<std::string>& variables)
{
	constexpr auto none = static_cast<std::size_t>(-1);
	std::array<std::size_t, 3> places = {none, none, none};
	for (std::size_t v = 0; v < variables.size(); ++v)
		if (const std::size_t axis = axisOf(variables[v]); axis < 3 && places[axis] == none)
			places[axis] = v;
	for (std::size_t& place : places)
		for (std::size_t v = 0; place == none && v < variables.size(); ++v)
			if (std::find(places.begin(), places.end(), v) == places.end())
				place = v;
	return places;
}

// Bricks stand for the other elements too, with corners that are the same.
int typeOfBrick(std::array<vtkIdType, 8>& c)
{
	if (c[4] == c[5] && c[5] == c[6] && c[6] == c[7])
	{
		if (c[2] != c[3])
			return VTK_PYRAMID;
		c[3] = c[4];
		return VTK_TETRA;
	}
	if (c[2] == c[3] && c[6] == c[7])
	{
		c = {c[0], c[1], c[2], c[4], c[5], c[6], 0, 0};
		return VTK_WEDGE;
	}
	return VTK_HEXAHEDRON;
}

void insertCells(const TecplotZone& zone, vtkUnstructuredGrid* grid)
{
	const auto corners = static_cast<std::size_t>(tecplotCorners(zone.element_type));
	const int type = zone.element_type == "TETRAHEDRON"     ? VTK_TETRA
	                 : zone.element_type == "QUADRILATERAL" ? VTK_QUAD
	                 : zone.element_type == "TRIANGLE"      ? VTK_TRIANGLE
	                                                        : VTK_LINE;
	grid->Allocate(static_cast<vtkIdType>(zone.elements));
	for (std::size_t e = 0; e < zone.elements; ++e)
	{
		std::array<vtkIdType, 8> ids = {};
		std::copy_n(zone.corners->begin() + static_cast<std::ptrdiff_t>(e * corners), corners, ids.begin());
		const int own = corners == 8 ? typeOfBrick(ids) : type;
		const int count = own == VTK_PYRAMID ? 5
		                  : own == VTK_WEDGE ? 6
		                  : own == VTK_TETRA ? 4
		                                     : static_cast<int>(corners);
		grid->InsertNextCell(own, count, ids.data());
	}
}

vtkSmartPointer<vtkPointSet> dataOf(const TecplotZone& zone)
{
	if (zone.element_type.empty())
	{
		const auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
		grid->SetDimensions(static_cast<int>(zone.points[0]), static_cast<int>(zone.points[1]),
		                    static_cast<int>(zone.points[2]));
		return grid;
	}
	const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	if (zone.faces)
	{
		cells::GrownCells cells;
		cells::addCellsByFaces(
		    cells, {zone.faces->starts, zone.faces->corners, zone.faces->left, zone.faces->right, zone.elements});
		cells.fill(grid);
	}
	else
		insertCells(zone, grid);
	return grid;
}

void addZone(const TecplotFile& file, const TecplotZone& zone, manifest::Writer& manifest)
{
	if (zone.element_type == "POLYGON")
		return manifest.warn(fmt::format("the flat polygons of {} are left out", zone.title));
	const auto places = placesOf(file.variables);
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	for (const std::size_t v : places)
		if (v >= zone.values.size() || !zone.values[v] || zone.cell_variables.contains(v))
			throw Refusal(fmt::format("nothing to slice: the points of {} have no three coordinates", zone.title));
	const auto& x = *zone.values[places[0]];
	points->SetNumberOfPoints(static_cast<vtkIdType>(x.size()));
	for (std::size_t p = 0; p < x.size(); ++p)
		points->SetPoint(static_cast<vtkIdType>(p), x[p], (*zone.values[places[1]])[p], (*zone.values[places[2]])[p]);

	const vtkSmartPointer<vtkPointSet> data = dataOf(zone);
	data->SetPoints(points);
	for (std::size_t v = 0; v < file.variables.size(); ++v)
	{
		if (!zone.values[v])
			manifest.warn(fmt::format("{} has no values in {}, where it is passive", file.variables[v], zone.title));
		if (!zone.values[v] || std::find(places.begin(), places.end(), v) != places.end())
			continue;
		vtkNew<vtkDoubleArray> array;
		array->SetName(file.variables[v].c_str());
		array->SetNumberOfTuples(static_cast<vtkIdType>(zone.values[v]->size()));
		std::copy(zone.values[v]->begin(), zone.values[v]->end(), array->GetPointer(0));
		if (zone.cell_variables.contains(v))
			data->GetCellData()->AddArray(array);
		else
			data->GetPointData()->AddArray(array);
	}
	manifest.setPrefix(zone.title);
	manifest.add(data);
}

} // namespace

void readTecplot(const Request& request, manifest::Writer& manifest)
{
	const MappedText text(request.file);
	const TecplotFile file = parseTecplot(text.text());
	if (text::endsInsideALine(request.file))
		manifest.warn(text::kCutTextWarning);
	std::vector<double> times;
	for (const TecplotZone& zone : file.zones)
		if (zone.time)
			times.push_back(*zone.time);
	times = manifest::inOrder(std::move(times));
	const std::optional<double> time = manifest::chooseIfAny(times, request);
	for (const TecplotZone& zone : file.zones)
		if (!zone.time || zone.time == time)
			addZone(file, zone, manifest);
	manifest.offerTimes(std::move(times));
}

} // namespace vp::reader::meshes
