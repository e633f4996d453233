#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkDataSet;
struct Request;

// A data set that was read, with what it holds besides the cells that are shown.
struct KeptBlock
{
	std::string name;
	vtkSmartPointer<vtkDataSet> data;
};

// Writes blocks in the VTK format that the ending of request.convert_to asks for. Throws a Refusal where that has no
// such grids.
void writeConverted(const std::vector<KeptBlock>& blocks, const Request& request);

// The same for one block as VTKHDF, in vprobe-read-more.
void writeVtkHdf(vtkDataSet* data, const std::string& file);
