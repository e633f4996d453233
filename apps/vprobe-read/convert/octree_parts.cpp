#include "octree_parts.h"

#include <algorithm>

namespace vp::reader::convert
{

namespace
{

constexpr int kLevels = 21;

class Division
{
public:
	Division(std::span<const CellOnCurve> cells, std::size_t most) : cells_(cells), most_(most) {}

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
		const auto isBefore = [&](const CellOnCurve& cell) { return ((cell.place >> shift) & 7) <= octant; };
		const auto first = cells_.begin();
		return static_cast<std::size_t>(std::partition_point(first + static_cast<std::ptrdiff_t>(begin),
		                                                     first + static_cast<std::ptrdiff_t>(end), isBefore) -
		                                first);
	}

	std::span<const CellOnCurve> cells_;
	std::size_t most_;
	std::vector<std::size_t> ends_;
};

} // namespace

std::vector<std::size_t> divide(std::span<const CellOnCurve> cells, std::size_t most)
{
	if (cells.empty())
		return {};
	Division division(cells, std::max<std::size_t>(most, 1));
	division.divide(0, cells.size(), 0);
	return division.take();
}

} // namespace vp::reader::convert
