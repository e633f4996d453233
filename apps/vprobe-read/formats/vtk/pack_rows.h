#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace vp::reader::vtk
{

// Numbers, of which each that occurs gets its place among those that occur.
class PointRanks
{
public:
	explicit PointRanks(std::uint64_t numbers) : bits_(numbers / 64 + 1, 0) {}

	void note(std::uint64_t number) { bits_[number / 64] |= std::uint64_t(1) << number % 64; }
	// To be called when all are noted.
	void count()
	{
		before_.resize(bits_.size());
		for (std::size_t word = 0; word < bits_.size(); ++word)
			before_[word] = std::exchange(size_, size_ + static_cast<std::uint64_t>(std::popcount(bits_[word])));
	}
	std::uint64_t size() const { return size_; }
	std::uint64_t rank(std::uint64_t number) const
	{
		const std::uint64_t lower = bits_[number / 64] & ((std::uint64_t(1) << number % 64) - 1);
		return before_[number / 64] + static_cast<std::uint64_t>(std::popcount(lower));
	}

private:
	std::vector<std::uint64_t> bits_;
	std::vector<std::uint64_t> before_;
	std::uint64_t size_ = 0;
};

// Runs of rows of a list of the file, which follow each other in memory.
class ChosenRows
{
public:
	void add(std::uint64_t in_file, std::uint64_t count)
	{
		in_file_.push_back(in_file);
		in_memory_.push_back(size_);
		size_ += count;
	}
	std::uint64_t size() const { return size_; }
	std::size_t count() const { return in_file_.size(); } // number of runs
	// Returns the rows of a run in memory, of all rows there.
	template <class Row>
	std::span<Row> of(std::size_t run, std::span<Row> rows) const
	{
		const std::uint64_t end = run + 1 < in_memory_.size() ? in_memory_[run + 1] : size_;
		return rows.subspan(in_memory_[run], end - in_memory_[run]);
	}
	std::uint64_t inMemory(std::size_t run) const { return in_memory_[run]; }
	// Calls visit(FIRST IN FILE, FIRST IN MEMORY, COUNT) for rows that follow each other in both.
	template <class Visit>
	void forEachPiece(Visit&& visit) const
	{
		for (std::size_t i = 0, next; i < in_file_.size(); i = next)
		{
			const auto end = [&](std::size_t run) { return run < in_memory_.size() ? in_memory_[run] : size_; };
			next = i + 1;
			while (next < in_file_.size() && in_file_[next] - in_file_[i] == in_memory_[next] - in_memory_[i])
				++next;
			visit(in_file_[i], in_memory_[i], end(next) - in_memory_[i]);
		}
	}

private:
	std::vector<std::uint64_t> in_file_, in_memory_;
	std::uint64_t size_ = 0;
};

} // namespace vp::reader::vtk
