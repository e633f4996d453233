#pragma once

#include "grid/field.h"
#include "vprobe-read/base/request.h"
#include "vprobe-read/hdf5/hdf5_file.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace vp::reader::manifest
{
class Writer;
}

namespace vp::reader::vtk
{

// A data set, and the time that is read of it.
struct VtkHdfPack
{
	std::string root;                 // its group
	std::string own;                  // the group of what `vprobe pack` has written beside it
	std::vector<std::size_t> steps{}; // in the order of their times; one if it has no times
	std::size_t chosen = 0;           // among them
};

// Returns true if `vprobe pack` has written the data set: an unstructured grid in parts that lie together in space
// (convert/write_pack.cpp, docs/FORMATS.md).
bool isVtkHdfPack(const hdf5::File& file, const VtkHdfPack& pack);

// Says whether an array is wanted. association: "Point" or "Cell".
using WantsVtkHdfArray = std::function<bool(const std::string& association, const std::string& name,
                                            grid::NumberType type, std::uint64_t components)>;

// Reads a pack at a time as one grid, or hands over where its cells lie, if the parent wants them there and can read
// them. Points
// that several parts have become one again, in the order of the packed file. Throws a Refusal.
void readVtkHdfPack(const hdf5::File& file, const VtkHdfPack& pack, const Request& request,
                    const WantsVtkHdfArray& wants, manifest::Writer& manifest);

} // namespace vp::reader::vtk
