#include "foam_averages.h"

#include "foam_grid.h"
#include "vprobe-read/base/is_one_of.h"

#include <vtkDataArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <array>
#include <limits>
#include <vector>

namespace vp::reader::codes
{

namespace
{

// Sums for the means of points.
class Means
{
public:
	Means(std::size_t points, int components)
	    : components_(static_cast<std::size_t>(components)), sums_(points * components_), counts_(points)
	{
	}

	void add(std::size_t point, const double* tuple)
	{
		++counts_[point];
		for (std::size_t c = 0; c < components_; ++c)
			sums_[point * components_ + c] += tuple[c];
	}
	bool has(std::size_t point) const { return counts_[point] > 0; }
	// NaN if nothing was added.
	double mean(std::size_t point, std::size_t c) const
	{
		return has(point) ? sums_[point * components_ + c] / counts_[point] : std::numeric_limits<double>::quiet_NaN();
	}

private:
	std::size_t components_;
	std::vector<double> sums_;
	std::vector<int> counts_;
};

// Patches that are parts of the boundary, and do not only tell its geometry. VTK's reader has the same ones.
bool isPhysical(const FoamPatch& patch)
{
	return isOneOf(patch.type, {"patch", "wall", "mappedWall"}) || patch.type.starts_with("processor");
}

void addFaces(const FoamMesh& mesh, const FoamField& field, Means& means)
{
	std::array<double, 9> tuple;
	for (std::size_t p = 0; p < mesh.patches.size(); ++p)
	{
		const FoamPatch& patch = mesh.patches[p];
		const FoamPatchValues& values = field.patches[p];
		if (!isPhysical(patch) || patch.faces == 0)
			continue;
		if (!values.unknown.empty())
			throw FoamUnknown(fmt::format("patch {}: {}", patch.name, values.unknown));
		for (std::int64_t i = 0; i < patch.faces; ++i)
		{
			const auto face = static_cast<std::size_t>(patch.first + i);
			if (values.values)
				foamTuple(*values.values, static_cast<std::size_t>(i), tuple.data());
			else
				foamTuple(*field.inside, static_cast<std::size_t>(mesh.owners[face]), tuple.data());
			for (const std::int64_t corner : mesh.faces[face])
				means.add(static_cast<std::size_t>(corner), tuple.data());
		}
	}
}

} // namespace

vtkSmartPointer<vtkDataArray> foamAverages(const FoamMesh& mesh, vtkUnstructuredGrid* grid, const FoamField& field,
                                           bool is_double)
{
	const int components = field.inside->components;
	const std::size_t points = mesh.points.size();
	Means cells(points, components), faces(points, components);
	addFaces(mesh, field, faces);
	std::array<double, 9> tuple;
	for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
	{
		vtkIdType count = 0;
		const vtkIdType* corners = nullptr;
		grid->GetCellPoints(cell, count, corners);
		foamTuple(*field.inside, static_cast<std::size_t>(cell), tuple.data());
		for (vtkIdType i = 0; i < count; ++i)
			cells.add(static_cast<std::size_t>(corners[i]), tuple.data());
	}
	FoamList means;
	means.components = components;
	for (std::size_t p = 0; p < points; ++p)
		for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
			means.numbers.push_back(faces.has(p) ? faces.mean(p, c) : cells.mean(p, c));
	const vtkSmartPointer<vtkDataArray> array = foamArray(FoamList(), 0, is_double);
	array->SetNumberOfComponents(components);
	array->SetNumberOfTuples(static_cast<vtkIdType>(points));
	for (std::size_t p = 0; p < points; ++p)
		array->SetTuple(static_cast<vtkIdType>(p), means.at(p));
	return array;
}

} // namespace vp::reader::codes
