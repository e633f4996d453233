#pragma once

#include <vtkSmartPointer.h>

#include <cstddef>
#include <string>
#include <vector>

class vtkDataSet;

namespace vp::reader
{
struct Request;
}

namespace vp::reader::convert
{

// A data set that was read, with everything that it holds besides the cells that are shown.
struct KeptBlock
{
	std::string name;
	vtkSmartPointer<vtkDataSet> data;
};

// Writes blocks in the VTK format that the ending of request.convert_to asks for. Throws a Refusal if that format has
// no such grids.
void writeConverted(const std::vector<KeptBlock>& blocks, const Request& request);

// Writes one block as VTKHDF, images in bricks. Their arrays may stay in the files that they come from (storedArray()).
// threads: the most to use. Only vprobe-read-more has this.
void writeVtkHdf(vtkDataSet* data, const std::string& file, int threads);

// Writes an unstructured grid in parts of at most so many cells. Only vprobe-read-more has this.
void writePack(vtkDataSet* data, const std::string& file, std::size_t cells_of_part, int threads);

} // namespace vp::reader::convert
