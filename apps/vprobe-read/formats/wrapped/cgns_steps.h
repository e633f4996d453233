#pragma once

#include "vprobe-read/base/memory_file.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::hdf5
{
class File;
}

namespace vp::reader::wrapped
{

// The nodes of a CGNS file of a kind, by their paths.
std::vector<std::string> cgnsChildren(const hdf5::File& file, const std::string& parent, std::string_view label);

// The times of a file's steps, as it has them, if they do not rise; else empty. Throws a Refusal if bases differ.
std::vector<double> unsortedCgnsTimes(const hdf5::File& file);

// A copy of such a file whose times are the numbers of the steps, from 0: VTK's reader wants times that rise. Throws a
// Refusal if the times lie in the file in another way than one after the other.
std::unique_ptr<MemoryFile> withNumberedSteps(const hdf5::File& file, const std::string& path);

} // namespace vp::reader::wrapped
