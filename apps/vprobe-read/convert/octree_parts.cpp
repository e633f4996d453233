#include "octree_parts.h"

#include "vprobe-read/quick/tasks.h"

#include <algorithm>

namespace vp::reader::convert
{

namespace
{

constexpr int kLevels = 21;
constexpr std::size_t kWorthAThread = 1 << 16;

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

void sortCells(std::vector<CellOnCurve>& cells, int threads)
{
	const std::size_t runs = std::clamp<std::size_t>(cells.size() / kWorthAThread, 1, std::max(threads, 1));
	const auto at = [&](std::size_t run) {
		return cells.begin() +
		       static_cast<std::ptrdiff_t>(cells.size() / runs * run + std::min(run, cells.size() % runs));
	};
	quick::Tasks tasks(threads);
	tasks.add(runs, [&](std::size_t run, arrays::Scratch&) { std::sort(at(run), at(run + 1)); });
	tasks.run();
	for (std::size_t run = 1; run < runs; ++run)
		std::inplace_merge(cells.begin(), at(run), at(run + 1));
}

class Division
{
public:
	Division(const std::vector<CellOnCurve>& cells, std::size_t most) : cells_(cells), most_(most) {}

	// Divides the cells of a cube. level: how often the whole was halved for it.
	void divide(std::size_t begin, std::size_t end, int level)
	{
		if (end - begin <= most_ || level == kLevels)
		{
			for (; end - begin > most_; begin += most_) // all of them in one place
				ends_.push_back(begin + most_);
			ends_.push_back(end);
			return;
		}
		std::size_t open = begin; // where a part begins that may grow
		for (std::uint64_t octant = 0; octant < 8; ++octant)
		{
			const std::size_t next = endOfOctant(begin, end, level, octant);
			if (next - begin > most_)
			{
				if (open < begin)
					ends_.push_back(begin);
				divide(begin, next, level + 1);
				open = next;
			}
			else if (next - open > most_)
			{
				ends_.push_back(begin);
				open = begin;
			}
			begin = next;
		}
		if (open < end)
			ends_.push_back(end);
	}

	std::vector<std::size_t> take() { return std::move(ends_); }

private:
	std::size_t endOfOctant(std::size_t begin, std::size_t end, int level, std::uint64_t octant) const
	{
		const int shift = 3 * (kLevels - 1 - level);
		const auto isBefore = [&](const CellOnCurve& cell) { return ((cell.first >> shift) & 7) <= octant; };
		const auto first = cells_.begin();
		return static_cast<std::size_t>(std::partition_point(first + static_cast<std::ptrdiff_t>(begin),
		                                                     first + static_cast<std::ptrdiff_t>(end), isBefore) -
		                                first);
	}

	const std::vector<CellOnCurve>& cells_;
	std::size_t most_;
	std::vector<std::size_t> ends_;
};

} // namespace

std::uint64_t mortonKey(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
	return spread(x) | spread(y) << 1 | spread(z) << 2;
}

std::vector<std::size_t> divide(std::vector<CellOnCurve>& cells, std::size_t most, int threads)
{
	if (cells.empty())
		return {};
	sortCells(cells, threads);
	Division division(cells, std::max<std::size_t>(most, 1));
	division.divide(0, cells.size(), 0);
	return division.take();
}

} // namespace vp::reader::convert
