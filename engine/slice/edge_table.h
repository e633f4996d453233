#pragma once

#include "base/raw_vector.h"

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

namespace vp::slice
{

// The cut edges of a mesh while several threads look them up: open addressing, at most three quarters full. An edge is
// known by its place in the table; of all who ask for it, the one with the least rank is its owner, whoever came first.
class EdgeTable
{
public:
	static constexpr std::uint32_t kFull = 0xFFFFFFFFu;

	explicit EdgeTable(std::size_t expected)
	    : slots_(std::bit_ceil(2 * expected + 64)), shift_(64 - std::countr_zero(slots_)),
	      keys_(static_cast<std::uint64_t*>(std::calloc(slots_, sizeof(std::uint64_t))), &std::free), owners_(slots_),
	      numbers_(slots_)
	{
		if (!keys_)
			throw std::bad_alloc();
	}

	// `key` is not 0.
	void prefetch(std::uint64_t key) const { __builtin_prefetch(&keys_.get()[place(key)]); }

	// Where the edge stands; kFull when the table should have been larger. Ranks are below 2^64 - 1.
	std::uint32_t find(std::uint64_t key, std::uint64_t rank)
	{
		for (std::size_t slot = place(key);; slot = (slot + 1) & (slots_ - 1))
		{
			std::atomic_ref<std::uint64_t> at(keys_.get()[slot]);
			std::uint64_t held = at.load(std::memory_order_acquire);
			if (held == 0)
			{
				if (used_.load(std::memory_order_relaxed) > slots_ / 4 * 3)
					return kFull;
				// What stands for the slot's owner until it has one must be there before its key is seen.
				if (at.compare_exchange_strong(held, kBusy, std::memory_order_acquire))
				{
					owners_[slot] = rank;
					at.store(key, std::memory_order_release);
					used_.fetch_add(1, std::memory_order_relaxed);
					return static_cast<std::uint32_t>(slot);
				}
			}
			while (held == kBusy)
				held = at.load(std::memory_order_acquire);
			if (held != key)
				continue;
			std::atomic_ref<std::uint64_t> owner(owners_[slot]);
			std::uint64_t least = owner.load(std::memory_order_relaxed);
			while (rank < least && !owner.compare_exchange_weak(least, rank, std::memory_order_relaxed))
				;
			return static_cast<std::uint32_t>(slot);
		}
	}

	// Once nobody looks up any more.
	bool isOwner(std::uint32_t slot, std::uint64_t rank) const { return owners_[slot] == rank; }
	void setNumber(std::uint32_t slot, std::uint32_t number) { numbers_[slot] = number; }
	std::uint32_t number(std::uint32_t slot) const { return numbers_[slot]; }

private:
	static constexpr std::uint64_t kBusy = ~0ull; // no edge: its points differ

	std::size_t place(std::uint64_t key) const
	{
		// Fibonacci hashing: the golden ratio of 2^64, upper bits taken.
		return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ull) >> shift_);
	}

	std::size_t slots_;
	int shift_;
	std::unique_ptr<std::uint64_t, decltype(&std::free)> keys_;
	RawVector<std::uint64_t> owners_;
	RawVector<std::uint32_t> numbers_;
	std::atomic<std::size_t> used_{0};
};

} // namespace vp::slice
