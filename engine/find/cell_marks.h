#pragma once

#include "base/ids.h"
#include "base/raw_vector.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace vp::find
{

// Remembers which cells a flood has met: one bit per cell, and one bit for each word of 64 bits that is not empty. So
// the cells can be listed in ascending order without a sort, and cleared, in time that depends on their number and on N
// / 4096.
class CellMarks
{
public:
	explicit CellMarks(std::size_t cells);

	// A thread marks cells with a pen, which it keeps by value.
	class Pen
	{
	public:
		explicit Pen(CellMarks& marks) : words_(marks.words_.get()), groups_(marks.groups_.get()) {}

		// Returns true if the cell has a mark. Between threads it is no more exact than mark().
		bool isMarked(CellId cell) const { return words_[cell / 64].load(std::memory_order_relaxed) >> cell % 64 & 1; }

		// Marks a cell. Returns true if the cell had no mark. This is not exact between threads, because nothing is
		// locked (a locked exchange would take longer than all other work for a cell): several callers may get true,
		// and one may undo the mark of another cell. So keep the cells that were met, and give them to settle() when
		// all threads are done.
		bool mark(CellId cell) const
		{
			const std::uint64_t bit = 1ull << cell % 64;
			std::atomic<std::uint64_t>& word = words_[cell / 64];
			const std::uint64_t before = word.load(std::memory_order_relaxed);
			if (before & bit)
				return false;
			word.store(before | bit, std::memory_order_relaxed);
			if (before == 0)
			{
				std::atomic<std::uint64_t>& group = groups_[cell / 4096];
				group.store(group.load(std::memory_order_relaxed) | 1ull << cell / 64 % 64, std::memory_order_relaxed);
			}
			return true;
		}

	private:
		std::atomic<std::uint64_t>* words_;
		std::atomic<std::uint64_t>* groups_;
	};

	// Makes sure that a cell is marked. Several threads may call it, but not while pens are in use.
	void settle(CellId cell)
	{
		setBit(words_[cell / 64], 1ull << cell % 64);
		setBit(groups_[cell / 4096], 1ull << cell / 64 % 64);
	}

	// Call this when all cells are settled: returns them in ascending order, and prepares rank().
	std::vector<CellId> list();
	// The place of a marked cell in the list.
	std::uint32_t rank(CellId cell) const
	{
		const std::uint64_t below = (1ull << cell % 64) - 1;
		return ranks_[cell / 64] + countBits(words_[cell / 64].load(std::memory_order_relaxed) & below);
	}
	void clear(); // number of cells that list() returned

	std::size_t bytes() const { return ranks_.size() * (8 + 4) + group_count_ * 8; }

private:
	// Counts bits in sums of wider and wider fields. std::popcount would call a function on machines that may lack the
	// instruction.
	static std::uint32_t countBits(std::uint64_t word)
	{
		word -= word >> 1 & 0x5555555555555555ull;
		word = (word & 0x3333333333333333ull) + (word >> 2 & 0x3333333333333333ull);
		word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0Full;
		return static_cast<std::uint32_t>(word * 0x0101010101010101ull >> 56);
	}
	static void setBit(std::atomic<std::uint64_t>& word, std::uint64_t bit)
	{
		if (!(word.load(std::memory_order_relaxed) & bit))
			word.fetch_or(bit, std::memory_order_relaxed);
	}
	std::size_t chunks() const { return (group_count_ + kChunkGroups - 1) / kChunkGroups; }
	template <class Visit>
	void forWords(std::size_t chunk, Visit&& visit) const;

	static constexpr std::size_t kChunkGroups = 128; // half a million cells

	std::unique_ptr<std::atomic<std::uint64_t>[]> words_;
	std::unique_ptr<std::atomic<std::uint64_t>[]> groups_;
	RawVector<std::uint32_t> ranks_; // rank of the first cell in a word that is not empty
	std::size_t group_count_;
};

} // namespace vp::find
