#pragma once

#include "foam_case.h"

#include <optional>
#include <string>

class vtkDoubleArray;
class vtkUnstructuredGrid;

// An element of a list, its components in VTK's order.
void foamTuple(const FoamList& list, std::size_t element, double* tuple);

// True if a number in single precision can be the rounded `exact`, or the average of numbers of about `size`.
bool roundsToFoam(double exact, double rounded, double size);

// The values that VTK's reader gives to points, in double precision: means of the faces of walls and patches around a
// point, else of its cells.
class FoamAverages
{
public:
	FoamAverages(const FoamCase& files, std::string region, vtkUnstructuredGrid* grid)
	    : files_(files), region_(std::move(region)), grid_(grid)
	{
	}

	// Replaces the point array of that name. Values that are none of those means stay as VTK has them.
	void widen(const FoamField& field, vtkDoubleArray* of_cells);

private:
	const std::optional<FoamMesh>& mesh();

	const FoamCase& files_;
	std::string region_;
	vtkUnstructuredGrid* grid_;
	bool has_tried_ = false;
	std::optional<FoamMesh> mesh_;
};
