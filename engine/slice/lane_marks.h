#pragma once

#include "slice/slicer.h"
#include "traverse/octant_queue.h"
#include "traverse/visited.h"

#include <deque>
#include <vector>

namespace vp::slice
{

// What the lanes of a traversal know their queued cells by; outlives it.
class LaneMarks
{
public:
	// The lane has its block and its seeds. pool: of the block.
	template <class Lane>
	void give(Lane& lane, Visited visited, traverse::VisitedPool& pool)
	{
		if (visited == Visited::octants)
			lane.queue = &queues_.emplace_back(*lane.block, lane.seeds.empty() ? 0 : lane.seeds.front());
		else
			lane.visited = loans_.emplace_back(pool.borrow()).get();
	}

private:
	std::vector<traverse::VisitedPool::Loan> loans_;
	std::deque<traverse::OctantQueue> queues_;
};

} // namespace vp::slice
