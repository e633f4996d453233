#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <hdf5.h>

namespace vp::reader::hdf5
{

// A chunk of a data set as it lies in the file.
struct Chunk
{
	std::vector<std::uint64_t> first; // its first value along each side of the set
	std::uint64_t offset = 0;         // in the file
	std::uint64_t bytes = 0;
	std::uint32_t left_out_filters = 0; // bit n: it was not packed by filter n
};

// Returns the chunks of a data set that were written, in any order. Returns nothing where the file has an index of
// another kind than the one that is walked here: version 1 B-trees, as HDF5 writes them unless it is asked for newer
// ones.
//
// HDF5 1.10 cannot list them: H5Dget_chunk_info() walks all chunks to find each one.
std::optional<std::vector<Chunk>> chunksOf(hid_t set, const std::string& file);

} // namespace vp::reader::hdf5
