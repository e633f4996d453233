#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace vp::gpu
{

/// Which bytes of a page of memory are free. Ranges that touch are one range. Not thread safe.
class FreeRanges
{
public:
	explicit FreeRanges(std::uint64_t bytes) : bytes_(bytes), free_(bytes)
	{
		if (bytes > 0)
			ranges_[0] = bytes;
	}

	/// Takes `bytes` (1 or more) at a multiple of `alignment` (a power of two), from the smallest range that has room
	/// for them, so that large ranges stay large. Returns where they begin, or nothing where no range has room.
	std::optional<std::uint64_t> take(std::uint64_t bytes, std::uint64_t alignment);
	/// Gives back what take() returned for as many bytes.
	void give(std::uint64_t begin, std::uint64_t bytes);

	std::uint64_t bytes() const { return bytes_; }
	std::uint64_t free() const { return free_; }
	bool allFree() const { return free_ == bytes_; }

private:
	std::uint64_t bytes_;
	std::uint64_t free_;
	std::map<std::uint64_t, std::uint64_t> ranges_; // begin to length
};

} // namespace vp::gpu
