#include "pack_columns.h"

#include "base/raw_vector.h"
#include "pack_division.h"

#include <condition_variable>
#include <cstring>
#include <mutex>
#include <vector>

namespace vp::reader::convert
{

namespace
{

constexpr std::size_t kCellsAtOnce = 1 << 15; // their rows fit into a cache

// Lets threads do something in the order of their numbers, one after the other.
class Turns
{
public:
	// Returns false if there is no turn any more.
	bool await(std::size_t number)
	{
		std::unique_lock lock(mutex_);
		changed_.wait(lock, [&] { return next_ == number || has_ended_; });
		return !has_ended_;
	}
	void pass()
	{
		const std::lock_guard lock(mutex_);
		++next_;
		changed_.notify_all();
	}
	void end()
	{
		const std::lock_guard lock(mutex_);
		has_ended_ = true;
		changed_.notify_all();
	}

private:
	std::mutex mutex_;
	std::condition_variable changed_;
	std::size_t next_ = 0;
	bool has_ended_ = false;
};

// Parts that follow each other, and what they have in each column.
class Batch
{
public:
	Batch(std::size_t begin, std::size_t end, const std::deque<Column>& columns) : columns_(columns)
	{
		for (const Column& column : columns)
		{
			std::size_t rows = 0;
			for (std::size_t part = begin; part < end; ++part)
				rows += column.rowsOf(part);
			RawVector<std::byte>& gathered = gathered_.emplace_back();
			gathered.resize(rows * column.row_bytes);
			std::byte* to = gathered.data();
			for (std::size_t part = begin; part < end; ++part)
			{
				column.gather(part, to);
				to += column.rowsOf(part) * column.row_bytes;
			}
		}
	}

	void write() const
	{
		H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // HDF5 keeps this for each thread
		for (std::size_t c = 0; c < columns_.size(); ++c)
			columns_[c].rows->append(gathered_[c].data(), gathered_[c].size() / columns_[c].row_bytes);
	}

private:
	const std::deque<Column>& columns_;
	std::vector<RawVector<std::byte>> gathered_;
};

// The compiler copies rows of a known size in an instruction or two.
template <std::size_t RowBytes>
void copyRowsOf(const std::byte* from, std::span<const std::uint32_t> rows, std::byte* to)
{
	for (std::size_t i = 0; i < rows.size(); ++i)
		std::memcpy(to + i * RowBytes, from + rows[i] * RowBytes, RowBytes);
}

} // namespace

void writeColumns(const PackDivision& division, const std::deque<Column>& columns)
{
	std::vector<std::size_t> ends;
	for (std::size_t part = 0, cells = 0; part < division.parts(); ++part)
	{
		cells += division.cells(part).size();
		if (cells < kCellsAtOnce && part + 1 < division.parts())
			continue;
		ends.push_back(part + 1);
		cells = 0;
	}
	Turns turns;
	division.forEach(ends.size(),
	                 [&](std::size_t number)
	                 {
		                 try
		                 {
			                 const Batch batch(number == 0 ? 0 : ends[number - 1], ends[number], columns);
			                 if (!turns.await(number))
				                 return;
			                 batch.write();
			                 turns.pass();
		                 }
		                 catch (...)
		                 {
			                 turns.end();
			                 throw;
		                 }
	                 });
}

void copyRows(const std::byte* from, std::size_t row_bytes, std::span<const std::uint32_t> rows, std::byte* to)
{
	switch (row_bytes)
	{
	case 1:
		return copyRowsOf<1>(from, rows, to);
	case 4:
		return copyRowsOf<4>(from, rows, to);
	case 8:
		return copyRowsOf<8>(from, rows, to);
	case 12:
		return copyRowsOf<12>(from, rows, to);
	case 24:
		return copyRowsOf<24>(from, rows, to);
	default:
		for (std::size_t i = 0; i < rows.size(); ++i)
			std::memcpy(to + i * row_bytes, from + rows[i] * row_bytes, row_bytes);
	}
}

} // namespace vp::reader::convert
