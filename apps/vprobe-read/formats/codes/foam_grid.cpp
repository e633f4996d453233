#include "foam_grid.h"

#include "vprobe-read/cells/cells_by_faces.h"
#include "vprobe-read/cells/grown_cells.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <vector>

namespace vp::reader::codes
{

namespace
{

vtkSmartPointer<vtkDataArray> newArray(bool is_double)
{
	if (is_double)
		return vtkSmartPointer<vtkDoubleArray>::New();
	return vtkSmartPointer<vtkFloatArray>::New();
}

} // namespace

void foamTuple(const FoamList& list, std::size_t element, double* tuple)
{
	constexpr std::array<std::size_t, 6> symmetric = {0, 3, 5, 1, 4, 2}; // from XX XY XZ YY YZ ZZ
	const double* from = list.at(element);
	for (std::size_t c = 0; c < static_cast<std::size_t>(list.components); ++c)
		tuple[c] = from[list.components == 6 ? symmetric[c] : c];
}

vtkSmartPointer<vtkDataArray> foamArray(const FoamList& list, std::size_t elements, bool is_double)
{
	const vtkSmartPointer<vtkDataArray> array = newArray(is_double);
	array->SetNumberOfComponents(list.components);
	array->SetNumberOfTuples(static_cast<vtkIdType>(elements));
	std::array<double, 9> tuple;
	for (std::size_t i = 0; i < elements; ++i)
	{
		foamTuple(list, i, tuple.data());
		array->SetTuple(static_cast<vtkIdType>(i), tuple.data());
	}
	return array;
}

vtkSmartPointer<vtkUnstructuredGrid> foamGrid(const FoamMesh& mesh)
{
	cells::GrownCells cells;
	cells::addCellsByFaces(cells, {mesh.faces.starts, mesh.faces.corners, mesh.owners, mesh.neighbours, mesh.cells});
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	points->SetData(foamArray(mesh.points, mesh.points.size(), mesh.is_double));
	grid->SetPoints(points);
	cells.fill(grid);
	return grid;
}

vtkSmartPointer<vtkPolyData> foamFacesOf(const FoamMesh& mesh, std::span<const FoamPatch* const> patches)
{
	std::vector<std::int64_t> used;
	for (const FoamPatch* patch : patches)
		for (std::int64_t face = patch->first; face < patch->first + patch->faces; ++face)
		{
			const auto corners = mesh.faces[static_cast<std::size_t>(face)];
			used.insert(used.end(), corners.begin(), corners.end());
		}
	std::sort(used.begin(), used.end());
	used.erase(std::unique(used.begin(), used.end()), used.end());
	FoamList places;
	places.components = 3;
	for (const std::int64_t point : used)
		places.numbers.insert(places.numbers.end(), mesh.points.at(static_cast<std::size_t>(point)),
		                      mesh.points.at(static_cast<std::size_t>(point)) + 3);
	vtkNew<vtkCellArray> polygons;
	for (const FoamPatch* patch : patches)
		for (std::int64_t face = patch->first; face < patch->first + patch->faces; ++face)
		{
			const auto corners = mesh.faces[static_cast<std::size_t>(face)];
			polygons->InsertNextCell(static_cast<int>(corners.size()));
			for (const std::int64_t corner : corners)
				polygons->InsertCellPoint(std::lower_bound(used.begin(), used.end(), corner) - used.begin());
		}
	vtkNew<vtkPoints> points;
	points->SetData(foamArray(places, used.size(), mesh.is_double));
	auto data = vtkSmartPointer<vtkPolyData>::New();
	data->SetPoints(points);
	data->SetPolys(polygons);
	return data;
}

} // namespace vp::reader::codes
