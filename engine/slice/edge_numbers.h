#pragma once

#include "base/ids.h"
#include "base/raw_vector.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vp::slice
{

// Numbers the edges of a small part of a mesh in the order in which they are first met. Open addressing over four-byte
// numbers, at most half full, with the edges beside in their order: so little memory that it stays in a core's cache.
class EdgeNumbers
{
public:
	explicit EdgeNumbers(std::size_t expected) { resize(std::bit_ceil(2 * expected + 64)); }

	static std::uint64_t keyOf(PointId lower, PointId higher) { return std::uint64_t(lower) << 32 | higher; }

	// Room for so many new edges.
	void makeRoom(std::size_t more)
	{
		while (count_ + more > edges_.size())
			grow();
	}

	// Looks edges up, as long as there is room for new ones, and keeps what it needs in registers; the count goes back
	// when it ends.
	class Search
	{
	public:
		explicit Search(EdgeNumbers& of)
		    : of_(of), slots_(of.slots_.data()), edges_(of.edges_.data()), mask_(of.slots_.size() - 1),
		      shift_(of.shift_), count_(of.count_)
		{
		}
		Search(const Search&) = delete;
		~Search() { of_.count_ = count_; }

		std::uint32_t find(std::uint64_t edge)
		{
			std::size_t slot = (edge * kGolden) >> shift_;
			for (std::uint32_t number = slots_[slot]; number != kEmpty; number = slots_[slot])
			{
				if (edges_[number] == edge)
					return number;
				slot = (slot + 1) & mask_;
			}
			slots_[slot] = count_;
			edges_[count_] = edge;
			return count_++;
		}

	private:
		EdgeNumbers& of_;
		std::uint32_t* slots_;
		std::uint64_t* edges_;
		std::size_t mask_;
		int shift_;
		std::uint32_t count_;
	};

	std::size_t size() const { return count_; }
	RawVector<std::uint64_t> takeEdges()
	{
		edges_.resize(count_);
		return std::move(edges_);
	}

private:
	static constexpr std::uint32_t kEmpty = 0xFFFFFFFFu;
	static constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ull; // of 2^64: Fibonacci hashing, upper bits taken

	void resize(std::size_t slots)
	{
		slots_.assign(slots, kEmpty);
		edges_.resize(slots / 2);
		shift_ = 64 - std::countr_zero(slots);
	}
	void grow()
	{
		resize(2 * slots_.size());
		for (std::uint32_t number = 0; number < count_; ++number)
		{
			std::size_t slot = (edges_[number] * kGolden) >> shift_;
			while (slots_[slot] != kEmpty)
				slot = (slot + 1) & (slots_.size() - 1);
			slots_[slot] = number;
		}
	}

	std::vector<std::uint32_t> slots_;
	RawVector<std::uint64_t> edges_;
	std::uint32_t count_ = 0;
	int shift_ = 0;
};

} // namespace vp::slice
