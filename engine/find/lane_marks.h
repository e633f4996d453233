#pragma once

#include "find/octant_queue.h"
#include "find/visited.h"

#include <deque>
#include <vector>

namespace vp::find
{

// What the lanes of a traversal know their queued cells by; outlives it.
class LaneMarks
{
public:
	// The lane has its block and its seeds. pool: of the block.
	template <class SheetInBlock>
	void give(SheetInBlock& lane, VisitedSet visited, VisitedPool& pool)
	{
		if (visited == VisitedSet::octants)
			lane.queue = &queues_.emplace_back(*lane.block, lane.seeds.empty() ? 0 : lane.seeds.front());
		else
			lane.visited = loans_.emplace_back(pool.borrow()).get();
	}

private:
	std::vector<VisitedPool::Loan> loans_;
	std::deque<OctantQueue> queues_;
};

} // namespace vp::find
