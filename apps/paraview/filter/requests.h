#pragma once

#include "kept_grid.h"
#include "ranks.h"
#include "settings.h"

#include <vtkSmartPointer.h>

#include <functional>

class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;

namespace vprobe_paraview
{

// What this rank has of the output. What is null is empty.
struct Parts
{
	std::vector<vtkSmartPointer<vtkPolyData>> sheets{};
	vtkSmartPointer<vtkPolyData> lines{};
	vtkSmartPointer<vtkPolyData> contours{};
	vtkSmartPointer<vtkPolyData> paths{};
};

// One cut of the filter, on this rank and together with the others.
struct Request
{
	vtkAlgorithm& filter;
	Settings settings; // with the arrays' names
	double tolerance = 0.0;
	KeptGrid& grid;
	Ranks ranks;

	// Fills the output, which is polydata or a multiblock. Returns the error that is to be told, or an empty text: it
	// is the same on all ranks.
	std::string run(vtkDataObject& input, vtkDataObject& output);
	std::vector<std::string> warnings{};

private:
	void watch(double progress, const std::function<void(std::stop_token)>& work);
	Whole whole(const std::vector<Leaf>& leaves);
	vprobe::Cut cut(vtkDataObject& input);                         // throws Refused, Cancelled
	std::string build(const vprobe::Cut& cut, Parts& parts) const; // what failed, or an empty text
	void fill(Parts parts, vtkDataObject& output);
};

} // namespace vprobe_paraview
