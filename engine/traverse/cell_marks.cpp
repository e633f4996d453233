#include "traverse/cell_marks.h"

namespace vp::traverse
{

std::vector<CellId> CellMarks::list()
{
	std::vector<CellId> cells;
	forWords(
	    [&](std::size_t w)
	    {
		    ranks_[w] = static_cast<std::uint32_t>(cells.size());
		    for (std::uint64_t bits = words_[w].load(std::memory_order_relaxed); bits; bits &= bits - 1)
			    cells.push_back(static_cast<CellId>(w * 64) + static_cast<CellId>(std::countr_zero(bits)));
	    });
	return cells;
}

void CellMarks::clear()
{
	forWords([&](std::size_t w) { words_[w].store(0, std::memory_order_relaxed); });
	for (std::size_t g = 0; g < group_count_; ++g)
		groups_[g].store(0, std::memory_order_relaxed);
}

} // namespace vp::traverse
