#include "foam_grid.h"

#include "cell_of_faces.h"
#include "grown_cells.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace
{

vtkSmartPointer<vtkDataArray> newArray(bool is_double)
{
	if (is_double)
		return vtkSmartPointer<vtkDoubleArray>::New();
	return vtkSmartPointer<vtkFloatArray>::New();
}

std::span<const std::int64_t> cornersOfFace(const FoamMesh& mesh, std::size_t face)
{
	const auto first = static_cast<std::size_t>(mesh.faces.starts[face]);
	return std::span(mesh.faces.corners).subspan(first, static_cast<std::size_t>(mesh.faces.starts[face + 1]) - first);
}

// The faces of all cells, one cell after the other.
struct FacesOfFoamCells
{
	explicit FacesOfFoamCells(const FoamMesh& mesh) : starts(mesh.cells + 1)
	{
		const auto each = [&](const auto& take)
		{
			for (std::size_t face = 0; face < mesh.owners.size(); ++face)
				take(mesh.owners[face], face);
			for (std::size_t face = 0; face < mesh.neighbours.size(); ++face)
				take(mesh.neighbours[face], face);
		};
		each([&](std::int64_t cell, std::size_t) { ++starts[static_cast<std::size_t>(cell) + 1]; });
		for (std::size_t cell = 0; cell < mesh.cells; ++cell)
			starts[cell + 1] += starts[cell];
		faces.resize(starts.back());
		std::vector<std::size_t> at = starts;
		each([&](std::int64_t cell, std::size_t face) { faces[at[static_cast<std::size_t>(cell)]++] = face; });
	}

	std::vector<std::size_t> starts, faces;
};

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
	const FacesOfFoamCells of(mesh);
	GrownCells cells;
	std::vector<FaceCorners> faces;
	for (std::size_t cell = 0; cell < mesh.cells; ++cell)
	{
		const std::size_t count = of.starts[cell + 1] - of.starts[cell];
		if (count < 4)
			throw damaged(fmt::format("cell {} of its mesh has {} faces", cell, count));
		faces.resize(count);
		for (std::size_t i = 0; i < count; ++i)
		{
			const std::size_t face = of.faces[of.starts[cell] + i];
			const auto corners = cornersOfFace(mesh, face);
			if (corners.size() < 3)
				throw damaged(fmt::format("face {} of its mesh has {} corners", face, corners.size()));
			faces[i].assign(corners.begin(), corners.end());
			if (mesh.owners[face] != static_cast<std::int64_t>(cell)) // seen from the owner
				std::reverse(faces[i].begin(), faces[i].end());
		}
		addCellOfFaces(cells, faces);
	}
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
			const auto corners = cornersOfFace(mesh, static_cast<std::size_t>(face));
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
			const auto corners = cornersOfFace(mesh, static_cast<std::size_t>(face));
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
