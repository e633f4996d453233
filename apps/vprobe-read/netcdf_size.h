#pragma once

#include <cstdint>
#include <optional>
#include <string>

// The bytes that a classic netCDF file (CDF-1, -2 or -5) must have for all its variables to lie inside; the netCDF
// library reads zeros past the end. Null where the header cannot be followed, or counts records as it streams.
std::optional<std::uint64_t> netcdfSize(const std::string& file);
