#include "foam_averages.h"

#include "is_one_of.h"
#include "refusal.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace
{

// Sums for the means of points, and of the sizes of what is summed.
class Means
{
public:
	Means(vtkIdType points, int components)
	    : components_(components), sums_(static_cast<std::size_t>(points * components)), sizes_(sums_.size()),
	      counts_(static_cast<std::size_t>(points))
	{
	}

	void add(std::int64_t point, const double* tuple)
	{
		++counts_[static_cast<std::size_t>(point)];
		for (int c = 0; c < components_; ++c)
		{
			sums_[index(point, c)] += tuple[c];
			sizes_[index(point, c)] += std::abs(tuple[c]);
		}
	}
	// False if it is not what VTK has, or there is none.
	bool take(std::int64_t point, const double* rounded, double* mean) const
	{
		const int count = counts_[static_cast<std::size_t>(point)];
		for (int c = 0; c < components_; ++c)
		{
			mean[c] = sums_[index(point, c)] / count;
			if (count == 0 || !roundsToFoam(mean[c], rounded[c], sizes_[index(point, c)] / count))
				return false;
		}
		return true;
	}

private:
	std::size_t index(std::int64_t point, int c) const { return static_cast<std::size_t>(point * components_ + c); }

	int components_;
	std::vector<double> sums_, sizes_;
	std::vector<int> counts_;
};

// The faces of those patches that VTK takes for parts of the boundary, and not of its geometry.
void addFaces(const FoamMesh& mesh, const FoamField& field, vtkDoubleArray* of_cells, Means& means)
{
	std::array<double, 9> tuple;
	for (const FoamPatch& patch : mesh.patches)
	{
		const auto found = field.patches.find(patch.name);
		const bool is_physical =
		    isOneOf(patch.type, {"patch", "wall", "mappedWall"}) || patch.type.starts_with("processor");
		if (!is_physical || found == field.patches.end())
			continue;
		const std::optional<FoamList>& values = found->second;
		if (values && !values->is_uniform && values->size() != static_cast<std::size_t>(patch.faces))
			continue;
		for (std::int64_t i = 0; i < patch.faces; ++i)
		{
			const auto face = static_cast<std::size_t>(patch.first + i);
			if (values)
				foamTuple(*values, static_cast<std::size_t>(i), tuple.data());
			else
				of_cells->GetTuple(mesh.owners[face], tuple.data());
			for (std::int64_t corner = mesh.faces.starts[face]; corner < mesh.faces.starts[face + 1]; ++corner)
				means.add(mesh.faces.corners[static_cast<std::size_t>(corner)], tuple.data());
		}
	}
}

} // namespace

void foamTuple(const FoamList& list, std::size_t element, double* tuple)
{
	constexpr std::array<std::size_t, 6> symmetric = {0, 3, 5, 1, 4, 2}; // from XX XY XZ YY YZ ZZ
	const double* from = list.at(element);
	for (std::size_t c = 0; c < static_cast<std::size_t>(list.components); ++c)
		tuple[c] = from[list.components == 6 ? symmetric[c] : c];
}

bool roundsToFoam(double exact, double rounded, double size)
{
	constexpr double tolerance = 16 * 0x1p-24; // VTK reads text by sums, which round too
	constexpr double largest = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::min();
	if (!std::isfinite(exact) || !std::isfinite(rounded))
		return std::abs(exact) > largest * (1 - tolerance) || std::isnan(exact) == std::isnan(rounded);
	return std::abs(exact - rounded) <= size * tolerance + least;
}

void FoamAverages::widen(const FoamField& field, vtkDoubleArray* of_cells)
{
	vtkDataArray* single = grid_->GetPointData()->GetArray(of_cells->GetName());
	const int components = of_cells->GetNumberOfComponents();
	if (!vtkFloatArray::SafeDownCast(single) || single->GetNumberOfComponents() != components)
		return;
	const vtkIdType points = grid_->GetNumberOfPoints();
	Means cells(points, components), faces(points, components);
	std::array<double, 9> tuple, mean;
	for (vtkIdType cell = 0; cell < grid_->GetNumberOfCells(); ++cell)
	{
		vtkIdType count = 0;
		const vtkIdType* corners = nullptr;
		grid_->GetCellPoints(cell, count, corners);
		of_cells->GetTuple(cell, tuple.data());
		for (vtkIdType i = 0; i < count; ++i)
			cells.add(corners[i], tuple.data());
	}
	if (mesh())
		addFaces(*mesh_, field, of_cells, faces);
	vtkNew<vtkDoubleArray> wide;
	wide->SetName(single->GetName());
	wide->SetNumberOfComponents(components);
	wide->SetNumberOfTuples(points);
	for (vtkIdType p = 0; p < points; ++p)
	{
		single->GetTuple(p, tuple.data());
		const bool is_mean = faces.take(p, tuple.data(), mean.data()) || cells.take(p, tuple.data(), mean.data());
		wide->SetTuple(p, is_mean ? mean.data() : tuple.data());
	}
	grid_->GetPointData()->AddArray(wide);
}

// Without it, the values of the boundary stay as VTK has them.
const std::optional<FoamMesh>& FoamAverages::mesh()
{
	if (!std::exchange(has_tried_, true))
		try
		{
			mesh_ = files_.mesh(region_, static_cast<std::size_t>(grid_->GetNumberOfPoints()),
			                    static_cast<std::size_t>(grid_->GetNumberOfCells()));
		}
		catch (const Refusal&)
		{
		}
	return mesh_;
}
