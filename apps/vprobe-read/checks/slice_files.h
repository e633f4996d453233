#pragma once

#include <string>
#include <vector>

namespace vp::reader::checks
{

// Pictures of two dimensions, one file each, which are the slices of a volume.
//
// Returns the TIFF and PNG files that a path means, in the order of the numbers in their names: those of a folder, or
// those that a pattern in the last part of the path matches ("slices/*.tif"). Returns none for any other path, and for
// a folder in which DICOM files may be.
std::vector<std::string> sliceFiles(const std::string& path);

} // namespace vp::reader::checks
