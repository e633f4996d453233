// Cases of MFIX, by a parser of our own: VTK's goes on with old values where a file ends early, keeps ghosts in the
// bounds and mirrors cylinders. Ghosts are left out here.
#include "mfix_values.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/grown_cells.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <cmath>

namespace vp::reader::codes
{

namespace
{

constexpr std::int32_t kMfixFluid = 10; // the first flag of cells that are no fluid

// Where cells begin and end along an axis, without the ghosts.
std::vector<double> mfixPlaces(const MfixRestart& mesh, std::size_t axis)
{
	std::vector<double> places = {axis == 0 ? mesh.start : 0.0};
	for (std::size_t i = 1; i + 1 < mesh.cells[axis]; ++i)
	{
		const double width = mesh.widths[axis][i];
		if (!(width > 0.0) || !std::isfinite(width))
			throw damaged(fmt::format("a cell has the width {}", width));
		places.push_back(places.back() + width);
	}
	return places;
}

// Calls `use` with the place of each cell along the axes, and its number among all, for those that are no ghosts.
template <class Use>
void eachMfixCell(const MfixRestart& mesh, Use&& use)
{
	for (std::size_t k = 1; k + 1 < mesh.cells[2]; ++k)
		for (std::size_t j = 1; j + 1 < mesh.cells[1]; ++j)
			for (std::size_t i = 1; i + 1 < mesh.cells[0]; ++i)
				use(i - 1, j - 1, k - 1, i + mesh.cells[0] * (j + mesh.cells[1] * k));
}

vtkSmartPointer<vtkDataSet> mfixBoxes(const MfixRestart& mesh)
{
	auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
	std::array<vtkSmartPointer<vtkDoubleArray>, 3> axes;
	std::array<int, 3> points;
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		axes[axis] = vtkSmartPointer<vtkDoubleArray>::New();
		for (const double place : mfixPlaces(mesh, axis))
			axes[axis]->InsertNextValue(place);
		points[axis] = static_cast<int>(axes[axis]->GetNumberOfValues());
	}
	grid->SetDimensions(points.data());
	grid->SetXCoordinates(axes[0]);
	grid->SetYCoordinates(axes[1]);
	grid->SetZCoordinates(axes[2]);
	vtkNew<vtkUnsignedCharArray> marks;
	marks->SetName(vtkDataSetAttributes::GhostArrayName());
	eachMfixCell(mesh, [&](std::size_t, std::size_t, std::size_t, std::size_t cell)
	             { marks->InsertNextValue(mesh.flags[cell] < kMfixFluid ? 0 : vtkDataSetAttributes::HIDDENCELL); });
	grid->GetCellData()->AddArray(marks);
	return grid;
}

// x is the distance from the axis y, z an angle: x and z become those of a plane. Cells at the axis are wedges.
vtkSmartPointer<vtkDataSet> mfixSectors(const MfixRestart& mesh)
{
	const std::vector<double> radii = mfixPlaces(mesh, 0), heights = mfixPlaces(mesh, 1), angles = mfixPlaces(mesh, 2);
	if (radii[0] < 0.0)
		throw damaged("a radius below 0");
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	for (const double angle : angles)
		for (const double height : heights)
			for (const double radius : radii)
				points->InsertNextPoint(radius * std::cos(angle), height, radius * std::sin(angle));
	cells::GrownCells cells;
	const auto at = [&](std::size_t i, std::size_t j, std::size_t k)
	{ return static_cast<vtkIdType>(i + radii.size() * (j + heights.size() * k)); };
	eachMfixCell(mesh,
	             [&](std::size_t i, std::size_t j, std::size_t k, std::size_t cell)
	             {
		             if (mesh.flags[cell] >= kMfixFluid)
			             return;
		             const bool is_wedge = radii[i] == 0.0;
		             for (const std::size_t up : {j, j + 1})
		             {
			             cells.addPoint(at(i, up, k));
			             if (!is_wedge)
				             cells.addPoint(at(i, up, k + 1));
			             cells.addPoint(at(i + 1, up, k + 1));
			             cells.addPoint(at(i + 1, up, k));
		             }
		             cells.endCell(is_wedge ? VTK_WEDGE : VTK_HEXAHEDRON);
	             });
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	grid->SetPoints(points);
	cells.fill(grid);
	return grid;
}

// A variable at the cells of the grid. Vectors about the axis are turned to x, y, z.
vtkSmartPointer<vtkFloatArray> mfixArray(const MfixRestart& mesh, const MfixValues& file, const MfixVariable& variable,
                                         std::size_t step)
{
	std::vector<std::vector<float>> parts;
	for (const std::size_t part : variable.parts)
		parts.push_back(file.values(part, step));
	auto array = vtkSmartPointer<vtkFloatArray>::New();
	array->SetName(variable.name.c_str());
	array->SetNumberOfComponents(static_cast<int>(parts.size()));
	const std::vector<double> angles = mfixPlaces(mesh, 2);
	eachMfixCell(mesh,
	             [&](std::size_t, std::size_t, std::size_t k, std::size_t cell)
	             {
		             if (mesh.is_cylindrical && mesh.flags[cell] >= kMfixFluid)
			             return; // which the grid lacks
		             std::array<double, 3> value = {0.0, 0.0, 0.0};
		             for (std::size_t c = 0; c < parts.size(); ++c)
			             value[c] = parts[c][cell];
		             if (mesh.is_cylindrical && parts.size() == 3)
		             {
			             const double angle = 0.5 * (angles[k] + angles[k + 1]);
			             const double out = value[0], around = value[2];
			             value[0] = out * std::cos(angle) - around * std::sin(angle);
			             value[2] = out * std::sin(angle) + around * std::cos(angle);
		             }
		             array->InsertNextTuple(value.data());
	             });
	return array;
}

} // namespace

void readMfix(const Request& request, manifest::Writer& manifest)
{
	const MappedText text(request.file);
	const MfixRestart mesh = parseMfixRestart(text.text());
	std::vector<std::string> empty;
	const std::deque<MfixValues> files = mfixValuesBeside(request.file, mesh, empty);
	if (files.empty())
		manifest.warn("no files of values (.SP1 and so on) lie beside this case");
	if (!empty.empty())
		manifest.warn(fmt::format("no time was written to its {}", fmt::join(empty, ", ")));
	std::vector<double> times;
	for (const MfixValues& file : files)
		times.insert(times.end(), file.times().begin(), file.times().end());
	times = manifest::inOrder(std::move(times));
	const double time = manifest::chooseIfAny(times, request).value_or(0.0);
	const auto grid = mesh.is_cylindrical ? mfixSectors(mesh) : mfixBoxes(mesh);
	std::vector<std::string> of_other_times;
	for (const MfixValues& file : files)
	{
		const std::size_t step = file.stepAt(time);
		for (const MfixVariable& variable : file.variables())
		{
			grid->GetCellData()->AddArray(mfixArray(mesh, file, variable, step));
			if (file.times()[step] != time)
				of_other_times.push_back(fmt::format("{} of {:g}", variable.name, file.times()[step]));
		}
	}
	if (!of_other_times.empty())
		manifest.warn(fmt::format("not every variable was written at the time {:g}; shown are {}", time,
		                          fmt::join(of_other_times, ", ")));
	manifest.setLengthUnits(mesh.length_units);
	manifest.setTimeUnits("s");
	manifest.offerTimes(std::move(times));
	manifest.add(grid);
}

} // namespace vp::reader::codes
