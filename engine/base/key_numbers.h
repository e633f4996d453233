#pragma once

#include "base/raw_vector.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vp
{

// Numbers keys, such as cut edges, in the order in which they are first met: open addressing with linear probing, at
// most half full.
class KeyNumbers
{
public:
	explicit KeyNumbers(std::size_t expected) { resize(std::bit_ceil(4 * expected + 16)); }

	struct Found
	{
		std::uint32_t number;
		bool is_new;
	};
	// `next` is the number that a new key gets; any but 2^32 - 1.
	Found find(std::uint64_t key, std::uint32_t next)
	{
		std::size_t slot = place(key);
		while (numbers_[slot] != kEmpty)
		{
			if (keys_[slot] == key)
				return {numbers_[slot], false};
			slot = (slot + 1) & (keys_.size() - 1);
		}
		keys_[slot] = key;
		numbers_[slot] = next;
		if (2 * ++used_ > keys_.size())
			grow();
		return {next, true};
	}
	bool has(std::uint64_t key) const
	{
		std::size_t slot = place(key);
		while (numbers_[slot] != kEmpty && keys_[slot] != key)
			slot = (slot + 1) & (keys_.size() - 1);
		return numbers_[slot] != kEmpty;
	}

private:
	static constexpr std::uint32_t kEmpty = 0xFFFFFFFFu;

	std::size_t place(std::uint64_t key) const
	{
		// Fibonacci hashing: the golden ratio of 2^64, upper bits taken.
		return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ull) >> shift_);
	}
	void resize(std::size_t slots)
	{
		keys_.resize(slots);
		numbers_.assign(slots, kEmpty);
		shift_ = 64 - std::countr_zero(slots);
	}
	void grow()
	{
		const RawVector<std::uint64_t> keys = std::move(keys_);
		const std::vector<std::uint32_t> numbers = std::move(numbers_);
		resize(2 * keys.size());
		for (std::size_t i = 0; i < keys.size(); ++i)
		{
			if (numbers[i] == kEmpty)
				continue;
			std::size_t slot = place(keys[i]);
			while (numbers_[slot] != kEmpty)
				slot = (slot + 1) & (keys_.size() - 1);
			keys_[slot] = keys[i];
			numbers_[slot] = numbers[i];
		}
	}

	RawVector<std::uint64_t> keys_; // where there is a number
	std::vector<std::uint32_t> numbers_;
	std::size_t used_ = 0;
	int shift_ = 0;
};

} // namespace vp
