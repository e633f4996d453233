#include "gpu/free_ranges.h"

#include <cassert>
#include <iterator>

namespace vp::gpu
{

std::optional<std::uint64_t> FreeRanges::take(std::uint64_t bytes, std::uint64_t alignment)
{
	const auto aligned = [alignment](std::uint64_t begin) { return (begin + alignment - 1) & ~(alignment - 1); };
	auto best = ranges_.end();
	for (auto range = ranges_.begin(); range != ranges_.end(); ++range)
	{
		const std::uint64_t skipped = aligned(range->first) - range->first;
		if (range->second < bytes || range->second - bytes < skipped)
			continue;
		if (best == ranges_.end() || range->second < best->second)
			best = range;
	}
	if (best == ranges_.end())
		return std::nullopt;

	const auto [first, length] = *best;
	const std::uint64_t begin = aligned(first);
	const std::uint64_t skipped = begin - first;
	if (const std::uint64_t rest = length - skipped - bytes; rest > 0)
		ranges_[begin + bytes] = rest; // the only step that may fail, so it comes first
	if (skipped == 0)
		ranges_.erase(best);
	else
		best->second = skipped;
	free_ -= bytes;
	return begin;
}

void FreeRanges::give(std::uint64_t begin, std::uint64_t bytes)
{
	const auto [range, is_new] = ranges_.emplace(begin, bytes);
	assert(is_new);
	free_ += bytes;
	if (const auto next = std::next(range); next != ranges_.end() && begin + bytes == next->first)
	{
		range->second += next->second;
		ranges_.erase(next);
	}
	if (range == ranges_.begin())
		return;
	if (const auto previous = std::prev(range); previous->first + previous->second == begin)
	{
		previous->second += range->second;
		ranges_.erase(range);
	}
}

} // namespace vp::gpu
