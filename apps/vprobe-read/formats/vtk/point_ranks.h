#pragma once

#include <bit>
#include <cstdint>
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

} // namespace vp::reader::vtk
