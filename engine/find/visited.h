#pragma once

#include "base/ids.h"
#include "base/pool.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

namespace vp::find
{

// How the traversal knows the cells that it has queued.
enum class VisitedSet
{
	stamps, // a byte a cell, in VisitedMarks
	octants // the queue is searched, nothing is kept over the grid (octant_queue.h)
};

// The paper's auxiliary list: one byte a cell that holds the number of the slice that queued it last. It is cleared
// only when the number wraps. A sheet in flight has one of its own, since sheets cross in the same cells.
class VisitedMarks
{
public:
	// Zeroed memory from calloc: pages that no slice touches are never mapped.
	explicit VisitedMarks(std::size_t cells)
	    : stamps_(static_cast<std::uint8_t*>(std::calloc(cells ? cells : 1, 1)), &std::free), cells_(cells)
	{
		if (!stamps_)
			throw std::bad_alloc();
	}

	void beginCut()
	{
		if (++cut_ == 0)
		{
			std::memset(stamps_.get(), 0, cells_);
			cut_ = 1;
		}
	}
	// True when the cell had not been queued in this slice yet.
	bool mark(CellId cell)
	{
		std::uint8_t& stamp = stamps_.get()[cell];
		const bool first = stamp != cut_;
		stamp = cut_;
		return first;
	}

private:
	std::unique_ptr<std::uint8_t, decltype(&std::free)> stamps_;
	std::size_t cells_;
	std::uint8_t cut_ = 0;
};

// Marks for one block, lent to sheets in flight and taken back; each loan is a slice of its own.
class VisitedPool
{
public:
	explicit VisitedPool(std::size_t cells)
	    : cells_(cells), pool_([cells] { return std::make_unique<VisitedMarks>(cells); })
	{
	}

	using Loan = Pool<VisitedMarks>::Loan;

	Loan borrow()
	{
		Loan marks = pool_.borrow();
		marks->beginCut();
		return marks;
	}
	std::size_t bytes() const { return pool_.made() * cells_; } // held by all marks of the pool

private:
	std::size_t cells_;
	Pool<VisitedMarks> pool_;
};

} // namespace vp::find
