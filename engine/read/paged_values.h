#pragma once

#include "base/sparse_memory.h"
#include "parts/file_extents.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace vp::read
{

/// The values of an array that lie in a file in one piece, in the order of its points or cells. They have the same
/// places in memory, and pages of some 4 KiB are read when rows of them are wanted.
class PagedValues
{
public:
	/// The array in the file: plain numbers. Its caller has checked that it lies there.
	struct Place
	{
		std::uint64_t offset = 0;
		std::uint64_t rows = 0;
		std::size_t row_bytes = 0;
		std::size_t swapped_bytes = 1; // width of a number whose bytes are in the other order; 1 if they are not
	};
	/// Bytes of the array from the first on to before the second.
	using Extent = std::pair<std::uint64_t, std::uint64_t>;

	PagedValues(std::shared_ptr<const parts::OpenFile> file, const Place& place);

	/// Notes that a row will be needed. Precondition: row < rows.
	void want(std::uint64_t row) { wanted_[row >> row_bits_] = true; }
	/// Returns which bytes are wanted and not there yet, ascending. If much of the array is wanted, all that is
	/// missing: a disk reads it in less time than pieces of it.
	std::vector<Extent> missing() const;
	/// Asks the system for bytes of this array, or of another one of its kind that begins elsewhere in the file.
	void announce(std::span<const Extent> extents, std::uint64_t offset) const;
	void announce(std::span<const Extent> extents) const { announce(extents, place_.offset); }
	/// Reads bytes. Several threads may read different ones. Throws parts::Unreadable.
	void read(const Extent& extent) const;
	/// Notes that these of missing() were read.
	void note(std::span<const Extent> extents);
	/// Returns the bytes that were wanted so far.
	std::vector<Extent> wanted() const;

	const std::shared_ptr<SparseMemory>& memory() const { return memory_; }
	const std::byte* row(std::uint64_t number) const { return memory_->data() + number * place_.row_bytes; }
	std::uint64_t bytesThere() const { return bytes_there_; }
	std::uint64_t bytes() const { return place_.rows * place_.row_bytes; }

private:
	template <class IsIn>
	std::vector<Extent> extentsOf(const IsIn& isIn) const;

	std::shared_ptr<const parts::OpenFile> file_;
	Place place_;
	unsigned row_bits_ = 0; // a page has 2 to the power of this rows
	std::shared_ptr<SparseMemory> memory_;
	std::vector<bool> wanted_, there_; // for each page
	std::uint64_t bytes_there_ = 0;
};

} // namespace vp::read
