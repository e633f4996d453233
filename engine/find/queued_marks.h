#pragma once

#include "find/octant_queue.h"
#include "find/visited.h"

#include <deque>
#include <vector>

namespace vp::find
{

// Marks the queued cells of each sheet in a traversal. It outlives the traversal.
class QueuedMarks
{
public:
	// The sheet has its block and its seeds. pool: the block's pool.
	template <class SheetInBlock>
	void give(SheetInBlock& sheet, VisitedSet visited, VisitedPool& pool)
	{
		if (visited == VisitedSet::octants)
			sheet.queue = &queues_.emplace_back(*sheet.block, sheet.seeds.empty() ? 0 : sheet.seeds.front());
		else
			sheet.visited = loans_.emplace_back(pool.borrow()).get();
	}

private:
	std::vector<VisitedPool::Loan> loans_;
	std::deque<OctantQueue> queues_;
};

} // namespace vp::find
