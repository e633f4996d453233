#include "grid/cell_runs.h"

#include <numeric>

namespace vp::grid
{

std::vector<std::uint32_t> CellRuns::all() const
{
	std::vector<std::uint32_t> numbers(runs_.size());
	std::iota(numbers.begin(), numbers.end(), 0u);
	return numbers;
}

} // namespace vp::grid
