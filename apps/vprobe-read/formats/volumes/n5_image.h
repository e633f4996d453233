#pragma once

#include "ome_zarr.h"

#include <filesystem>
#include <string>

namespace vp::reader::volumes
{

// Returns the image in a folder of N5: a data set, or a group with one data set for each level, "s0" the finest. Throws
// a Refusal if there is none, which names one that is in the folder.
OmeZarr n5Image(const std::filesystem::path& folder);

} // namespace vp::reader::volumes
