#include "grid/morton.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace vp::grid
{

namespace
{

constexpr int kAxisBits = 21;

// 11 bits sort a 63-bit key in six passes; 2048 counters of a chunk stay in the first-level cache.
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

void sortByKey(std::unique_ptr<KeyedId[]>& items, std::size_t count)
{
	if (count < 2)
		return;
	const auto differing = [&](const tbb::blocked_range<std::size_t>& range, std::uint64_t bits)
	{
		for (std::size_t i = range.begin(); i < range.end(); ++i)
			bits |= items[i].key ^ items[0].key;
		return bits;
	};
	const std::uint64_t used = tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, count, 65536), std::uint64_t(0),
	                                                differing, std::bit_or<>{});

	// Least significant digit first. Each pass counts the digits of every chunk, turns the counts into places, and
	// moves.
	const std::size_t chunk = std::max<std::size_t>(count / 64, 16384);
	const std::size_t chunks = (count + chunk - 1) / chunk;
	std::vector<std::array<std::uint32_t, kDigits>> places(chunks);
	std::unique_ptr<KeyedId[]> other(new KeyedId[count]);
	for (int shift = 0; shift < 64; shift += kDigitBits)
	{
		if ((used >> shift & (kDigits - 1)) == 0)
			continue;
		const auto digit = [shift](const KeyedId& item) { return item.key >> shift & (kDigits - 1); };
		tbb::parallel_for(std::size_t(0), chunks,
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
		tbb::parallel_for(std::size_t(0), chunks,
		                  [&](std::size_t c)
		                  {
			                  for (std::size_t i = c * chunk; i < std::min(count, (c + 1) * chunk); ++i)
				                  other[places[c][digit(items[i])]++] = items[i];
		                  });
		std::swap(items, other);
	}
}

} // namespace vp::grid
