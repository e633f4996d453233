#include "grid/cell_runs.h"

#include <numeric>

namespace vp::grid
{

std::vector<std::uint32_t> CellRuns::all() const
{
	std::vector<std::uint32_t> numbers(own_.end - own_.begin);
	std::iota(numbers.begin(), numbers.end(), own_.begin);
	return numbers;
}

} // namespace vp::grid
