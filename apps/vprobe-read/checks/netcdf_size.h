#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>

// The bytes that a classic netCDF file (CDF-1, -2 or -5) must have for all its variables to lie inside; the netCDF
// library reads zeros past the end. Null where the header cannot be followed, or counts records as it streams.
std::optional<std::uint64_t> netcdfSize(const std::string& file);

// Throws a Refusal for a classic file with fewer bytes than that. HDF5 checks its own end.
void refuseShortNetcdf(const std::string& file);

// The names of its dimensions, variables and global attributes, as far as the header can be followed.
std::set<std::string> netcdfNames(const std::string& file);
