#include "find/cell_marks.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace vp::find
{

CellMarks::CellMarks(std::size_t cells)
    : words_(std::make_unique<std::atomic<std::uint64_t>[]>(cells / 64 + 1)),
      groups_(std::make_unique<std::atomic<std::uint64_t>[]>(cells / 4096 + 1)), ranks_(cells / 64 + 1),
      group_count_(cells / 4096 + 1)
{
}

// Calls visit(number of a word that is not empty) for a chunk, in ascending order.
template <class Visit>
void CellMarks::forWords(std::size_t chunk, Visit&& visit) const
{
	for (std::size_t g = chunk * kChunkGroups; g < std::min(group_count_, (chunk + 1) * kChunkGroups); ++g)
		for (std::uint64_t bits = groups_[g].load(std::memory_order_relaxed); bits; bits &= bits - 1)
			visit(g * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
}

std::vector<CellId> CellMarks::list()
{
	std::vector<std::uint32_t> starts(chunks() + 1);
	tracedFor(std::size_t(0), chunks(),
	          [&](std::size_t chunk)
	          {
		          std::uint32_t count = 0;
		          forWords(chunk,
		                   [&](std::size_t w) { count += countBits(words_[w].load(std::memory_order_relaxed)); });
		          starts[chunk] = count;
	          });
	std::uint32_t sum = 0;
	for (std::uint32_t& start : starts)
		sum += std::exchange(start, sum);
	std::vector<CellId> cells(sum);
	tracedFor(std::size_t(0), chunks(),
	          [&](std::size_t chunk)
	          {
		          std::uint32_t rank = starts[chunk];
		          forWords(chunk,
		                   [&](std::size_t w)
		                   {
			                   ranks_[w] = rank;
			                   std::uint64_t bits = words_[w].load(std::memory_order_relaxed);
			                   for (; bits; bits &= bits - 1)
				                   cells[rank++] =
				                       static_cast<CellId>(w * 64) + static_cast<CellId>(std::countr_zero(bits));
		                   });
	          });
	return cells;
}

void CellMarks::clear()
{
	tracedFor(std::size_t(0), chunks(),
	          [&](std::size_t chunk)
	          {
		          forWords(chunk, [&](std::size_t w) { words_[w].store(0, std::memory_order_relaxed); });
		          const std::size_t end = std::min(group_count_, (chunk + 1) * kChunkGroups);
		          for (std::size_t g = chunk * kChunkGroups; g < end; ++g)
			          groups_[g].store(0, std::memory_order_relaxed);
	          });
}

} // namespace vp::find
