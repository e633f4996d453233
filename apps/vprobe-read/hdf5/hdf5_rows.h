#pragma once

#include "hdf5_file.h"
#include "vprobe-read/base/refusal.h"

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace vp::reader::hdf5
{

// A data set as a list of rows, from which runs of rows are read. Where its numbers lie in the file as they are in
// memory, any number of threads read at once, without HDF5.
class Rows
{
public:
	// type: of the numbers in memory. Throws a Refusal if the set is not there, or is no list of rows.
	Rows(const File& file, int descriptor, std::string path, grid::NumberType type);

	// Leaves so many rows of the list, from the row `first` on. Throws a Refusal if they are not there.
	void narrow(std::uint64_t first, std::uint64_t count);

	std::uint64_t size() const { return count_; }
	std::uint64_t components() const { return sides_.size() == 2 ? sides_[1] : 1; }
	std::size_t rowBytes() const { return components() * grid::byteSize(type_); }
	grid::NumberType type() const { return type_; }

	// Returns where they begin in the file, if they lie there one behind the other as they are in memory.
	std::optional<std::uint64_t> plainOffset() const { return offset_; }
	// Asks the system for rows that will be read soon.
	void askFor(std::uint64_t first, std::uint64_t count) const;
	// Reads `count` rows. Any thread may call it. Throws a Refusal if they are not there.
	void read(std::uint64_t first, std::uint64_t count, void* to) const;

private:
	Refusal shortOfRows() const;

	const File& file_;
	int descriptor_;
	std::string path_;
	grid::NumberType type_;
	std::vector<std::uint64_t> sides_;
	std::uint64_t first_ = 0; // row in the data set
	std::uint64_t count_ = 0;
	std::optional<std::uint64_t> offset_;
	static std::mutex one_at_a_time_; // HDF5
};

} // namespace vp::reader::hdf5
