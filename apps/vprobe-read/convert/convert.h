#pragma once

#include <vtkSmartPointer.h>

#include <cstddef>
#include <functional>
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

// The times of a file, of which all are packed.
struct TimesToPack
{
	std::vector<double> times{}; // ascending; one or none: what was kept is all there is
	std::size_t kept = 0;        // the one at which the blocks were kept
	// Reads the data sets of another one.
	using Read = std::vector<vtkSmartPointer<vtkDataSet>>;
	std::function<Read(std::size_t time)> read{};
};

// Writes blocks in the VTK format that the ending of request.convert_to asks for. Throws a Refusal if that format has
// no such grids. Returns lines that the user should know.
std::vector<std::string> writeConverted(const std::vector<KeptBlock>& blocks, const TimesToPack& times,
                                        const Request& request);

// Writes one block as VTKHDF, images in bricks. Their arrays may stay in the files that they come from (storedArray()).
// threads: the most to use. Only vprobe-read-more has this.
void writeVtkHdf(vtkDataSet* data, const std::string& file, int threads);

// Writes unstructured grids in parts of at most request.cells_of_part cells, with their values at all times, or the
// index of request.file, without values. Throws a Refusal if cells or points are others at another time. Only
// vprobe-read-more has this. Returns lines that the user should know.
std::vector<std::string> writePack(const std::vector<KeptBlock>& blocks, const TimesToPack& times,
                                   const std::string& file, const Request& request);

} // namespace vp::reader::convert
