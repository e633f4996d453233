#include "hdf5_chunk_reader.h"

#include "hdf5_parts.h"
#include "hdf5_set.h"
#include "parts/part_bytes.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <mutex>

namespace vp::reader::hdf5
{

namespace
{

// HDF5 works for one thread at a time.
std::mutex& hdf5Mutex()
{
	static std::mutex mutex;
	return mutex;
}

hid_t openedQuietly(const std::string& file)
{
	H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it would print its own stack of errors
	H5PLset_loading_state(0);                    // a file does not choose code to load
	return H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
}

// HDF5 1.10 calls it an error that nobody wrote a chunk. Then the function that was asked has found it out itself, and
// there is no other below it. All else fails in the functions that read the index.
bool isNeverWritten()
{
	return H5Eget_num(H5E_DEFAULT) == 2;
}

} // namespace

ChunkReader::ChunkReader(const std::string& file, const std::string& path, std::vector<std::uint64_t> front)
    : file_(openedQuietly(file), H5Fclose), set_(openedSet(file_, path)), front_(std::move(front))
{
	const Handle properties(set_ < 0 ? -1 : H5Dget_create_plist(set_), H5Pclose);
	const Handle type(set_ < 0 ? -1 : H5Dget_type(set_), H5Tclose);
	if (properties < 0 || type < 0)
		throw damaged(fmt::format("{} cannot be opened", path));
	sides_ = sidesOfSet(set_);
	chunk_ = chunkSidesOf(properties, sides_.size());
	filters_ = Filters::of(properties);
	unsigned options = 0;
	bool is_known = chunk_.size() >= front_.size() + 3 && chunk_.size() <= front_.size() + 4 && filters_ &&
	                H5Pget_chunk_opts(properties, &options) >= 0;
	for (std::size_t side = 0; is_known && side < front_.size(); ++side)
		is_known = front_[side] < sides_[side] && chunk_[side] == 1;
	chunk_bytes_ = H5Tget_size(type);
	for (const std::uint64_t side : chunk_)
		is_known = is_known && !__builtin_mul_overflow(chunk_bytes_, side, &chunk_bytes_);
	if (!is_known)
		throw damaged(fmt::format("{} has other chunks than are asked for", path));
	packs_edges_ = (options & H5D_CHUNK_DONT_FILTER_PARTIAL_CHUNKS) == 0;
	fill_ = fillOf(set_, properties, 1);
	hsize_t bytes = 0;
	const Handle its_file(H5Iget_file_id(set_), H5Fclose); // another one where a link leads there
	if (H5Fget_filesize(its_file, &bytes) < 0)
		throw damaged("HDF5 does not tell its size");
	file_bytes_ = bytes;
}

std::vector<hsize_t> ChunkReader::firstOf(std::uint64_t number) const
{
	std::vector<hsize_t> first(front_.begin(), front_.end());
	first.resize(sides_.size());
	for (std::size_t side = front_.size() + 3; side-- > front_.size();)
	{
		const std::uint64_t along = (sides_[side] - 1) / chunk_[side] + 1;
		first[side] = number % along * chunk_[side];
		number /= along;
	}
	if (number > 0)
		throw damaged("it has fewer chunks than are asked for");
	return first;
}

bool ChunkReader::reachesBeyond(const std::vector<hsize_t>& first) const
{
	for (std::size_t side = 0; side < first.size(); ++side)
		if (chunk_[side] > sides_[side] - first[side])
			return true;
	return false;
}

ChunkReader::Packed ChunkReader::packed(const std::vector<hsize_t>& first) const
{
	const std::lock_guard lock(hdf5Mutex());
	hsize_t bytes = 0;
	Packed packed;
	if (H5Dget_chunk_storage_size(set_, first.data(), &bytes) < 0)
	{
		if (!isNeverWritten())
			throw damaged("a chunk cannot be found");
		return packed;
	}
	// HDF5 is not told how much room there is, and a chunk is in one piece.
	if (bytes > file_bytes_)
		throw damaged(fmt::format("a chunk of {} bytes in a file of {}", bytes, file_bytes_));
	packed.bytes.resize(bytes);
	if (bytes > 0 && H5Dread_chunk(set_, H5P_DEFAULT, first.data(), &packed.left_out_filters, packed.bytes.data()) < 0)
		throw damaged("a chunk cannot be read");
	return packed;
}

void ChunkReader::read(std::uint64_t number, std::span<std::byte> to) const
{
	if (to.size() != chunk_bytes_)
		throw damaged(fmt::format("its chunks have {} bytes where {} are asked for", chunk_bytes_, to.size()));
	const std::vector<hsize_t> first = firstOf(number);
	const Packed packed = this->packed(first);
	if (packed.bytes.empty())
		parts::fillItems(to, std::as_bytes(std::span(fill_)));
	else if (!packs_edges_ && reachesBeyond(first))
		filters_->unpack(packed.bytes, ~std::uint32_t(0), to);
	else
		filters_->unpack(packed.bytes, packed.left_out_filters, to);
}

} // namespace vp::reader::hdf5
