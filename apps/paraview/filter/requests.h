#pragma once

#include "kept_grid.h"
#include "ranks.h"
#include "settings.h"

#include <vtkSmartPointer.h>

#include <functional>

class vtkAlgorithm;
class vtkDataObject;
class vtkMultiProcessController;

namespace vprobe_paraview
{

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
	vprobe::Cut cut(vtkDataObject& input); // throws Refused, Cancelled
	std::string fill(const vprobe::Cut& cut, vtkDataObject& output);
};

} // namespace vprobe_paraview
