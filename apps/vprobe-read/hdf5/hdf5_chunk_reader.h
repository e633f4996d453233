#pragma once

#include "hdf5_filters.h"
#include "hdf5_handle.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <hdf5.h>

namespace vp::reader::hdf5
{

// Reads single chunks of a data set, whatever index the file has of them: HDF5 looks each of them up. Any thread may
// use it.
class ChunkReader
{
public:
	// front: as in storedPlaceOf(). Throws a Refusal unless the set is one that storedPlaceOf() leaves to it.
	ChunkReader(const std::string& file, const std::string& path, std::vector<std::uint64_t> front);

	// Reads a chunk by its number among those of the image, with its bytes in the order of the file. What was never
	// written is the fill value. Throws a Refusal unless the chunk has as many bytes as `to`.
	void read(std::uint64_t number, std::span<std::byte> to) const;

private:
	struct Packed
	{
		std::vector<std::byte> bytes; // none if nobody wrote the chunk
		std::uint32_t left_out_filters = 0;
	};
	Packed packed(const std::vector<hsize_t>& first) const;
	std::vector<hsize_t> firstOf(std::uint64_t number) const;
	bool reachesBeyond(const std::vector<hsize_t>& first) const;

	Handle file_;
	Handle set_;
	std::vector<std::uint64_t> front_;
	std::vector<std::uint64_t> sides_;
	std::vector<std::uint64_t> chunk_;
	std::uint64_t chunk_bytes_ = 1;
	std::uint64_t file_bytes_ = 0;
	std::optional<Filters> filters_;
	std::string fill_; // the bytes of a number
	bool packs_edges_ = true;
};

} // namespace vp::reader::hdf5
