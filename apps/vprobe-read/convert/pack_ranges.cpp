#include "pack_ranges.h"

#include "grid/shown_value.h"
#include "pack_division.h"
#include "read/run_ranges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

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

void gatherRanges(const PackDivision& division, std::size_t part, const grid::Field& values, std::byte* to)
{
	const std::size_t columns = read::columnsOfRanges(values.components);
	for (const PackRun& run : division.runs(part))
		for (std::size_t column = 0; column < columns; ++column)
		{
			const bool is_length = column + 1 == columns && columns > 1;
			const int component = is_length ? grid::kMagnitude : static_cast<int>(column);
			Range range;
			for (const std::uint32_t point : run.points)
				range.include(grid::shownValue(values, point, component));
			const float ends[2] = {range.low(), range.high()};
			std::memcpy(to, ends, sizeof(ends));
			to += sizeof(ends);
		}
}

} // namespace vp::reader::convert
