#pragma once

#include "vprobe-read/base/request.h"
#include "vprobe-read/hdf5/hdf5_file.h"

#include <string>

namespace vp::reader::manifest
{
class Writer;
}

namespace vp::reader::vtk
{

// A data set of a VTKHDF file.
struct VtkHdfSet
{
	const hdf5::File& file;
	std::string type; // ImageData or UnstructuredGrid
	std::string root; // its group
	std::string own;  // the group that `vprobe pack` may have written beside it
};

// Throws a Refusal.
void readVtkHdfSet(const VtkHdfSet& set, const Request& request, manifest::Writer& manifest);

} // namespace vp::reader::vtk
