#pragma once

#include "hdf5_handle.h"
#include "vprobe-read/base/refusal.h"

#include <string>

namespace vp::reader::hdf5
{

// Opens a data set. Looks for values that lie in other files beside this one first. The handle is less than 0 if HDF5
// cannot open it.
Handle openedSet(hid_t file, const std::string& path);

// Throws a Refusal if values of a data set lie in another file that is missing or too short. HDF5 would return zeros
// for them, without an error.
void refuseMissingParts(hid_t set, const std::string& path);

// Does the same for all data sets of a file that another library reads through HDF5. Does nothing for other formats.
void refuseMissingParts(const std::string& file);

// Returns why a data set could not be read: it is damaged, or packed by a filter that HDF5 does not have.
Refusal unreadSet(hid_t set, const std::string& path);

} // namespace vp::reader::hdf5
