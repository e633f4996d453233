#pragma once

#include <string>

// Throws a Refusal for a Zarr group of version 2 that holds an array whose unpacked chunks have another number of bytes
// than they should: netCDF would read what lies in memory behind them.
void refuseShortChunks(const std::string& folder);
