#include "pack_ranges.h"

#include "grid/shown_value.h"
#include "pack_division.h"
#include "read/run_ranges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace vp::reader::convert
{

namespace
{

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Range
{
	double lo = kInfinity;
	double hi = -kInfinity;

	void include(double value)
	{
		if (!std::isfinite(value))
			return;
		lo = std::min(lo, value);
		hi = std::max(hi, value);
	}
	float low() const
	{
		const auto rounded = static_cast<float>(lo);
		return rounded > lo ? std::nextafter(rounded, -kInfinity) : rounded;
	}
	float high() const
	{
		const auto rounded = static_cast<float>(hi);
		return rounded < hi ? std::nextafter(rounded, kInfinity) : rounded;
	}
};

} // namespace

void gatherRanges(const PackDivision& division, std::size_t part, const grid::Field& values, std::vector<std::byte>& to)
{
	const std::size_t columns = read::columnsOfRanges(values.components);
	std::vector<Range> ranges(division.runs(part).size() * columns);
	const std::span<const std::uint32_t> cells = division.cells(part);
	const auto include = [&](std::size_t run, std::size_t point)
	{
		for (std::size_t column = 0; column < columns; ++column)
		{
			const bool is_length = column + 1 == columns && columns > 1;
			const int component = is_length ? grid::kMagnitude : static_cast<int>(column);
			ranges[run * columns + column].include(grid::shownValue(values, point, component));
		}
	};
	division.withLists(
	    [&](const auto* offsets, const auto* ids)
	    {
		    for (std::size_t c = 0; c < cells.size(); ++c)
			    for (auto i = offsets[cells[c]]; i < division.endOf(cells[c], offsets); ++i)
				    include(c / division.cellsOfRun(), static_cast<std::size_t>(ids[i]));
	    });
	for (const Range& range : ranges)
	{
		const float ends[2] = {range.low(), range.high()};
		const std::span<const std::byte> bytes = std::as_bytes(std::span(ends));
		to.insert(to.end(), bytes.begin(), bytes.end());
	}
}

} // namespace vp::reader::convert
