#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace vp::reader::checks
{

// Returns the number of bytes that a classic netCDF file (CDF-1, -2 or -5) must have to hold all its variables. The
// netCDF library reads zeros past the end. Returns nothing if the header is damaged, or if it is written as a stream,
// without the number of records.
std::optional<std::uint64_t> netcdfSize(const std::string& file);

// Throws a Refusal for a classic file with fewer bytes than netcdfSize(). HDF5 checks its own end.
void refuseShortNetcdf(const std::string& file);

// Returns the names of the file's dimensions, variables and global attributes, as far as the header is readable.
std::set<std::string> netcdfNames(const std::string& file);

} // namespace vp::reader::checks
