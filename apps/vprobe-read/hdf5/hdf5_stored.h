#pragma once

#include "vprobe-read/arrays/stored_array.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <hdf5.h>

namespace vp::reader::hdf5
{

// Returns where the values of an image lie, which are a part of a data set: one value (of all components) for each
// point or cell. layout: of the image. front: numbers along the sides before those of the image, such as that of a
// time. Returns nothing if the values do not lie in the file as they are: packed, compact, elsewhere, or of a type that
// is none of ours; or if the data set has other sides.
std::optional<arrays::StoredPlace> storedPlaceOf(hid_t file, const std::string& name_of_file, const std::string& path,
                                                 const arrays::ValueLayout& layout,
                                                 const std::vector<std::uint64_t>& front);

// Returns where the numbers of a data set begin in the file, if they lie there one after the other, as they are in
// memory. Else nothing.
std::optional<std::uint64_t> plainOffsetOf(hid_t file, const std::string& name_of_file, const std::string& path,
                                           grid::NumberType type);

} // namespace vp::reader::hdf5
