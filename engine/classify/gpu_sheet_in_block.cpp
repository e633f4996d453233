#include "classify/gpu_sheet_in_block.h"

#include <cmath>
#include <limits>

namespace vp::classify
{

float boundedAbove(double value)
{
	return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

std::size_t axisTexels(const grid::AnyGrid& any)
{
	return std::visit(
	    [](const auto& grid) -> std::size_t
	    {
		    if constexpr (requires { grid.coordinate(0, 0u); })
			    return std::size_t(grid.points()[0]) + grid.points()[1] + grid.points()[2];
		    else
			    return 0;
	    },
	    any);
}

} // namespace vp::classify
