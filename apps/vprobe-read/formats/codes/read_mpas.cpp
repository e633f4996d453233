// Results of MPAS, as prisms over the cells of its mesh. VTK 9.1's reader puts values of layers at points of others.
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/grown_cells.h"
#include "vprobe-read/checks/netcdf_size.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/formats/volumes/cf_values.h"
#include "vprobe-read/hdf5/hdf5_parts.h"
#include "vprobe-read/hdf5/netcdf_file.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <numeric>

namespace vp::reader::codes
{

namespace
{

// The thickness of a layer: the files say it, if at all, in each model's own way. ParaView takes this too.
constexpr double kMpasThickness = 10000.0;

using MpasSides = std::vector<std::pair<std::string, std::size_t>>;

struct MpasMesh
{
	std::size_t cells, vertices, layers;
	std::vector<std::size_t> tops; // how many layers each cell has
};

std::vector<double> mpasValues(const hdf5::NetcdfFile& file, const char* name, std::size_t count)
{
	const int variable = file.variable(name);
	if (variable < 0)
		throw damaged(fmt::format("it has no {}", name));
	std::vector<double> values = volumes::cfNumbers(file, variable);
	if (values.size() != count)
		throw damaged(fmt::format("{} has {} values for {}", name, values.size(), count));
	return values;
}

// Layers go down into an ocean and up into an atmosphere: away from the vertex, or along z on a plane.
vtkSmartPointer<vtkPoints> mpasPoints(const hdf5::NetcdfFile& file, const MpasMesh& mesh)
{
	const std::vector<double> x = mpasValues(file, "xVertex", mesh.vertices);
	const std::vector<double> y = mpasValues(file, "yVertex", mesh.vertices);
	const std::vector<double> z = mpasValues(file, "zVertex", mesh.vertices);
	const bool on_sphere = file.text(NC_GLOBAL, "on_a_sphere").starts_with('Y');
	const double step = file.variable("zgrid") >= 0 ? kMpasThickness : -kMpasThickness;
	auto points = vtkSmartPointer<vtkPoints>::New();
	points->SetDataTypeToDouble();
	for (std::size_t layer = 0; layer <= mesh.layers; ++layer)
		for (std::size_t v = 0; v < mesh.vertices; ++v)
		{
			const double away = step * static_cast<double>(layer);
			const double scale = on_sphere ? 1.0 + away / std::hypot(x[v], y[v], z[v]) : 1.0;
			points->InsertNextPoint(scale * x[v], scale * y[v], scale * z[v] + (on_sphere ? 0.0 : away));
		}
	return points;
}

void addMpasPrism(cells::GrownCells& cells, const std::vector<vtkIdType>& corners)
{
	if (corners.size() != 6 && corners.size() != 8)
		return cells.addPrism(corners);
	for (const vtkIdType corner : corners)
		cells.addPoint(corner);
	cells.endCell(corners.size() == 6 ? VTK_WEDGE : VTK_HEXAHEDRON);
}

vtkSmartPointer<vtkUnstructuredGrid> mpasGrid(const hdf5::NetcdfFile& file, const MpasMesh& mesh)
{
	const int listed = file.variable("verticesOnCell");
	const MpasSides sides = listed < 0 ? MpasSides() : file.dimensions(listed);
	if (sides.size() != 2 || sides[0].second != mesh.cells)
		throw damaged("its cells list no vertices");
	const std::vector<double> lists = volumes::cfNumbers(file, listed);
	const std::vector<double> counts = mpasValues(file, "nEdgesOnCell", mesh.cells);
	cells::GrownCells cells;
	for (std::size_t cell = 0; cell < mesh.cells; ++cell)
	{
		if (!(counts[cell] >= 3 && counts[cell] <= static_cast<double>(sides[1].second)))
			throw damaged(fmt::format("cell {} has {} edges", cell, counts[cell]));
		const auto count = static_cast<std::size_t>(counts[cell]);
		for (std::size_t layer = 0; layer < mesh.tops[cell]; ++layer)
		{
			std::vector<vtkIdType> corners;
			for (std::size_t i = 0; i < 2 * count; ++i)
			{
				const double vertex = lists[cell * sides[1].second + i % count];
				if (!(vertex >= 1.0 && vertex <= static_cast<double>(mesh.vertices)))
					throw damaged(fmt::format("cell {} has a vertex that is not there", cell));
				corners.push_back(static_cast<vtkIdType>(vertex) - 1 +
				                  static_cast<vtkIdType>((layer + i / count) * mesh.vertices));
			}
			addMpasPrism(cells, corners);
		}
	}
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	grid->SetPoints(mpasPoints(file, mesh));
	cells.fill(grid);
	return grid;
}

// Variables of [Time], nCells and nVertLevels.
void addMpasArrays(const hdf5::NetcdfFile& file, const MpasMesh& mesh, std::size_t step, vtkUnstructuredGrid* grid)
{
	for (const auto& [variable, name, type] : file.variables())
	{
		const MpasSides sides = file.dimensions(variable);
		const bool has_time = !sides.empty() && sides[0].first == "Time";
		const std::size_t first = has_time ? 1 : 0;
		if (volumes::cfTypeOf(file, variable) == 0 || sides.size() != first + 2 || sides[first].first != "nCells" ||
		    sides[first + 1].first != "nVertLevels")
			continue;
		volumes::CfSlab slab = volumes::CfSlab::of(file, variable);
		if (has_time)
			slab.fix(0, step);
		const std::vector<double> values = volumes::cfNumbers(file, variable, slab);
		vtkNew<vtkDoubleArray> array;
		array->SetName(name.c_str());
		for (std::size_t cell = 0; cell < mesh.cells; ++cell)
			for (std::size_t layer = 0; layer < mesh.tops[cell]; ++layer)
				array->InsertNextValue(values[cell * mesh.layers + layer]);
		grid->GetCellData()->AddArray(array);
	}
}

} // namespace

void readMpas(const Request& request, manifest::Writer& manifest)
{
	checks::refuseShortNetcdf(request.file);
	hdf5::refuseMissingParts(request.file);
	const hdf5::NetcdfFile file(request.file);
	MpasMesh mesh{file.length("nCells"), file.length("nVertices"), file.length("nVertLevels"), {}};
	if (mesh.layers == 0 || mesh.cells == 0)
		throw Refusal("nothing to slice: a mesh of MPAS without layers (nVertLevels)");
	if (mesh.layers > 1 << 16)
		throw damaged(fmt::format("{} layers", mesh.layers));
	mesh.tops.assign(mesh.cells, mesh.layers);
	if (file.variable("maxLevelCell") >= 0) // where the ocean is less deep
	{
		const std::vector<double> deepest = mpasValues(file, "maxLevelCell", mesh.cells);
		for (std::size_t cell = 0; cell < mesh.cells; ++cell)
			mesh.tops[cell] = static_cast<std::size_t>(
			    std::clamp(std::isfinite(deepest[cell]) ? deepest[cell] : 0.0, 0.0, static_cast<double>(mesh.layers)));
	}
	std::vector<double> times(file.length("Time"));
	std::iota(times.begin(), times.end(), 0.0);
	const std::optional<double> time = manifest::chooseIfAny(times, request);
	const auto grid = mpasGrid(file, mesh);
	addMpasArrays(file, mesh, static_cast<std::size_t>(time.value_or(0.0)), grid);
	manifest.offerTimes(std::move(times));
	manifest.add(grid);
}

} // namespace vp::reader::codes
