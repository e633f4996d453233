#include "surface/grid_index.h"

#include "surface/number_text.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <string_view>

namespace vp::surface
{

GridLayers layersOf(double index, std::uint32_t cells)
{
	assert(index >= 0.0 && index <= cells && cells > 0);
	const double below = std::floor(index);
	const auto layer = static_cast<std::uint32_t>(below);
	if (index > below || layer == 0)
		return {layer};
	return {layer - 1, layer < cells};
}

char axisName(int axis)
{
	return static_cast<char>('i' + axis);
}

std::string nameOf(const GridIndex& at)
{
	return fmt::format("{}={}", axisName(at.axis), at.index);
}

std::string GridIndexRange::text() const
{
	return isOne() ? fmt::format("{}={}", axisName(axis), first)
	               : fmt::format("{}={}..{}", axisName(axis), first, last);
}

Result<GridIndexRange> parseGridIndex(const std::string& text)
{
	if (text.size() < 2 || text[0] < 'i' || text[0] > 'k' || text[1] != '=')
		return Error{ErrorKind::usage,
		             "takes i=, j= or k= and a point index from 0, such as i=12.5, or patch=NAME; other "
		             "surfaces are not known"};
	const std::string_view numbers = std::string_view(text).substr(2);
	const std::size_t dots = numbers.find("..");
	const std::optional<double> first = numberOf(numbers.substr(0, dots));
	const std::optional<double> last = dots == std::string_view::npos ? first : numberOf(numbers.substr(dots + 2));
	if (!first || !last)
		return Error{ErrorKind::usage,
		             fmt::format("after {}= goes a point index, such as 12.5, or for a sweep a range, "
		                         "such as 0..12.5",
		                         text[0])};
	return GridIndexRange{text[0] - 'i', *first, *last};
}

} // namespace vp::surface
