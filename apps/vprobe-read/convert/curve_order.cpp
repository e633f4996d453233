#include "curve_order.h"

#include "vprobe-read/quick/tasks.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace vp::reader::convert
{

namespace
{

// Cells go into buckets first, the cubes of this level of an octree, so that what is left to sort fits into a cache.
constexpr int kBucketLevel = 4;
constexpr std::size_t kBuckets = (std::size_t(1) << 3 * kBucketLevel) + 1; // the last one lies behind the curve
constexpr std::size_t kCellsOfBlock = 1 << 16;

std::size_t bucketOf(std::uint64_t place)
{
	return place >> (63 - 3 * kBucketLevel);
}

// Spreads the 21 lowest bits so that each has two empty ones behind it.
std::uint64_t spread(std::uint64_t bits)
{
	bits &= 0x1FFFFF;
	bits = (bits | bits << 32) & 0x001F00000000FFFF;
	bits = (bits | bits << 16) & 0x001F0000FF0000FF;
	bits = (bits | bits << 8) & 0x100F00F00F00F00F;
	bits = (bits | bits << 4) & 0x10C30C30C30C30C3;
	return (bits | bits << 2) & 0x1249249249249249;
}

} // namespace

std::uint64_t mortonKey(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
	return spread(x) | spread(y) << 1 | spread(z) << 2;
}

HugeVector<CellOnCurve> alongCurve(std::size_t cells, const PlacesOnCurve& placesOf, int threads)
{
	const std::size_t blocks = (cells + kCellsOfBlock - 1) / kCellsOfBlock;
	// The cells of each block in each bucket, and then where the next one goes.
	std::vector<std::uint32_t> counts(blocks * kBuckets, 0);
	const auto forEachCell = [&](const auto& use)
	{
		quick::Tasks tasks(threads);
		tasks.add(blocks,
		          [&](std::size_t block, arrays::Scratch&)
		          {
			          const std::size_t first = block * kCellsOfBlock;
			          std::vector<std::uint64_t> places(std::min(kCellsOfBlock, cells - first));
			          placesOf(first, places);
			          for (std::size_t c = 0; c < places.size(); ++c)
				          use(counts[block * kBuckets + bucketOf(places[c])], places[c], first + c);
		          });
		tasks.run();
	};
	forEachCell([](std::uint32_t& count, std::uint64_t, std::size_t) { ++count; });
	std::vector<std::uint32_t> ends;
	std::uint32_t end = 0;
	for (std::size_t bucket = 0; bucket < kBuckets; ++bucket)
	{
		for (std::size_t block = 0; block < blocks; ++block)
			end += std::exchange(counts[block * kBuckets + bucket], end);
		ends.push_back(end);
	}
	HugeVector<CellOnCurve> sorted;
	sorted.resize(cells);
	forEachCell(
	    [&](std::uint32_t& next, std::uint64_t place, std::size_t cell) {
		    sorted[next++] = {place, static_cast<std::uint32_t>(cell)};
	    });
	quick::Tasks tasks(threads);
	tasks.add(kBuckets,
	          [&](std::size_t bucket, arrays::Scratch&)
	          {
		          const std::size_t begin = bucket == 0 ? 0 : ends[bucket - 1];
		          std::sort(sorted.data() + begin, sorted.data() + ends[bucket],
		                    [](const CellOnCurve& a, const CellOnCurve& b)
		                    { return a.place != b.place ? a.place < b.place : a.cell < b.cell; });
	          });
	tasks.run();
	return sorted;
}

} // namespace vp::reader::convert
