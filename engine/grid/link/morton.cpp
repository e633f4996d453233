#include "grid/link/morton.h"

#include "base/parallel_for.h"
#include "base/parallel_reduce.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace vp::grid
{

namespace
{

constexpr int kAxisBits = 21;

// 2048 counters of a chunk stay in the first-level cache.
constexpr int kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t(1) << kDigitBits;

// Moves bit i of 21 bits to bit 3 i.
std::uint64_t spread(std::uint64_t x)
{
	x = (x | x << 32) & 0x001f00000000ffffull;
	x = (x | x << 16) & 0x001f0000ff0000ffull;
	x = (x | x << 8) & 0x100f00f00f00f00full;
	x = (x | x << 4) & 0x10c30c30c30c30c3ull;
	x = (x | x << 2) & 0x1249249249249249ull;
	return x;
}

// By the digits from bit `first` on, least significant digit first. Each pass counts the digits of every chunk, turns
// the counts into places, and moves. used: the bits in which keys differ.
void sortDigits(KeyedIds& items, std::uint64_t used, int first)
{
	const std::size_t count = items.size();
	const std::size_t chunk = std::max<std::size_t>(count / 64, 16384);
	const std::size_t chunks = (count + chunk - 1) / chunk;
	std::vector<std::array<std::uint32_t, kDigits>> places(chunks);
	KeyedIds other(count);
	for (int shift = first; shift < 64; shift += kDigitBits)
	{
		if ((used >> shift & (kDigits - 1)) == 0)
			continue;
		const auto digit = [shift](const KeyedId& item) { return item.key >> shift & (kDigits - 1); };
		parallelFor(std::size_t(0), chunks,
		            [&](std::size_t c)
		            {
			            places[c].fill(0);
			            for (std::size_t i = c * chunk; i < std::min(count, (c + 1) * chunk); ++i)
				            ++places[c][digit(items[i])];
		            });
		std::uint32_t place = 0;
		for (std::size_t d = 0; d < kDigits; ++d)
			for (std::size_t c = 0; c < chunks; ++c)
				place += std::exchange(places[c][d], place);
		parallelFor(std::size_t(0), chunks,
		            [&](std::size_t c)
		            {
			            for (std::size_t i = c * chunk; i < std::min(count, (c + 1) * chunk); ++i)
				            other[places[c][digit(items[i])]++] = items[i];
		            });
		std::swap(items, other);
	}
}

// Runs of more equal upper digits than this are not for a comparing sort: all but a few keys may be there, where a
// point lies far out.
constexpr std::size_t kLongRun = 65536;

// Sorts the runs of keys that are equal from bit `first` on by the rest. False, with nothing lost, where one is long.
bool sortEqualRuns(std::span<KeyedId> items, int first)
{
	const std::size_t count = items.size();
	const auto endOfRun = [&](std::size_t begin, std::size_t last)
	{
		std::size_t end = begin + 1;
		while (end < last && end - begin <= kLongRun && items[end].key >> first == items[begin].key >> first)
			++end;
		return end;
	};
	const std::size_t chunks = (count + kLongRun - 1) / kLongRun;
	std::vector<std::size_t> starts(chunks + 1, count); // where the runs start; found before any run is changed
	parallelFor(std::size_t(0), chunks,
	            [&](std::size_t c) { starts[c] = c == 0 ? 0 : endOfRun(c * kLongRun - 1, count); });
	std::atomic<bool> all_short{true};
	parallelFor(std::size_t(0), chunks,
	            [&](std::size_t c)
	            {
		            for (std::size_t begin = starts[c]; begin < starts[c + 1];)
		            {
			            const std::size_t end = endOfRun(begin, starts[c + 1]);
			            if (end - begin > kLongRun)
				            all_short = false;
			            else if (end - begin > 1)
				            std::stable_sort(items.begin() + begin, items.begin() + end,
				                             [](const KeyedId& a, const KeyedId& b) { return a.key < b.key; });
			            begin = end;
		            }
	            });
	return all_short;
}

} // namespace

MortonCurve::MortonCurve(const Box& bounds)
{
	if (bounds.empty())
		return;
	const Vec3 size = bounds.size();
	const double edge = std::max({size.x, size.y, size.z});
	lo_ = bounds.lo;
	// An extent beyond the range of a double leaves all positions equal, and so in their source order.
	if (edge > 0.0 && std::isfinite(edge))
		scale_ = (1 << kAxisBits) / edge;
	if (!std::isfinite(scale_))
		scale_ = 0.0;
}

std::uint64_t MortonCurve::operator()(const Vec3& position) const
{
	std::uint64_t code = 0;
	for (int axis = 0; axis < 3; ++axis)
	{
		if (std::isnan(position[axis]))
			return kLast;
		constexpr double top = (1 << kAxisBits) - 1;
		const double step = (position[axis] - lo_[axis]) * scale_;
		const double clamped = step > 0.0 ? std::min(step, top) : 0.0;
		code |= spread(static_cast<std::uint64_t>(clamped)) << axis;
	}
	return code;
}

void sortByKey(KeyedIds& items)
{
	const std::size_t count = items.size();
	if (count < 2)
		return;
	const auto differing = [&](const tbb::blocked_range<std::size_t>& range, std::uint64_t bits)
	{
		for (std::size_t i = range.begin(); i < range.end(); ++i)
			bits |= items[i].key ^ items[0].key;
		return bits;
	};
	const std::uint64_t used = parallelReduce(count, 65536, std::uint64_t(0), differing, std::bit_or<>{});

	// The upper three digits part the keys but for those that lie close together: half the passes.
	constexpr int kUpper = 63 - 3 * kDigitBits;
	sortDigits(items, used, kUpper);
	if ((used & ((std::uint64_t(1) << kUpper) - 1)) != 0 && !sortEqualRuns(items, kUpper))
		sortDigits(items, used, 0);
}

} // namespace vp::grid
