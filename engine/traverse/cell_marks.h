#pragma once

#include "base/ids.h"

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace vp::traverse
{

// Which cells a flood has met, one bit each, and which words of 64 bits are not empty: so they are listed in ascending
// order without a sort, and cleared, in time that follows their number and N / 4096.
class CellMarks
{
public:
	explicit CellMarks(std::size_t cells)
	    : words_(std::make_unique<std::atomic<std::uint64_t>[]>(cells / 64 + 1)),
	      groups_(std::make_unique<std::atomic<std::uint64_t>[]>(cells / 4096 + 1)), ranks_(cells / 64 + 1),
	      group_count_(cells / 4096 + 1)
	{
	}

	// True for the one caller who was first. Thread safe.
	bool mark(CellId cell)
	{
		const std::uint64_t bit = 1ull << cell % 64;
		std::atomic<std::uint64_t>& word = words_[cell / 64];
		if (word.load(std::memory_order_relaxed) & bit)
			return false;
		const std::uint64_t before = word.fetch_or(bit, std::memory_order_relaxed);
		if (before == 0)
			groups_[cell / 4096].fetch_or(1ull << cell / 64 % 64, std::memory_order_relaxed);
		return !(before & bit);
	}

	// Once all are marked: the cells in ascending order. Makes rank() known.
	std::vector<CellId> list();
	// The place of a marked cell in the list.
	std::uint32_t rank(CellId cell) const
	{
		const std::uint64_t below = (1ull << cell % 64) - 1;
		return ranks_[cell / 64] +
		       static_cast<std::uint32_t>(std::popcount(words_[cell / 64].load(std::memory_order_relaxed) & below));
	}
	void clear(); // of what list() gave

	std::size_t bytes() const { return ranks_.size() * (8 + 4) + group_count_ * 8; }

private:
	template <class Visit>
	void forWords(Visit&& visit)
	{
		for (std::size_t g = 0; g < group_count_; ++g)
			for (std::uint64_t bits = groups_[g].load(std::memory_order_relaxed); bits; bits &= bits - 1)
				visit(g * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
	}

	std::unique_ptr<std::atomic<std::uint64_t>[]> words_;
	std::unique_ptr<std::atomic<std::uint64_t>[]> groups_;
	std::vector<std::uint32_t> ranks_; // of the first cell of a word that is not empty
	std::size_t group_count_;
};

} // namespace vp::traverse
