#pragma once

#include "hdf5_handle.h"
#include "vprobe-read/base/refusal.h"

#include <string>

// Opens a data set. Values that lie in other files are looked for beside this one first. Less than 0 where HDF5 cannot
// open it.
Hdf5Handle openedSet(hid_t file, const std::string& path);

// Throws a Refusal where values of a data set lie in another file that is missing or too short, which HDF5 would give
// as zeros and without a word.
void refuseMissingParts(hid_t set, const std::string& path);

// The same for all data sets of a file that another library reads through HDF5. Nothing for files of other formats.
void refuseMissingParts(const std::string& file);

// Why a data set could not be read: damaged, or packed by a filter that HDF5 does not bring.
Refusal unreadSet(hid_t set, const std::string& path);
