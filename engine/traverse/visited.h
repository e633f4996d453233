#pragma once

#include "base/ids.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <vector>

namespace vp::traverse
{

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

	void beginSlice()
	{
		if (++slice_ == 0)
		{
			std::memset(stamps_.get(), 0, cells_);
			slice_ = 1;
		}
	}
	// True when the cell had not been queued in this slice yet.
	bool mark(CellId cell)
	{
		std::uint8_t& stamp = stamps_.get()[cell];
		const bool first = stamp != slice_;
		stamp = slice_;
		return first;
	}

private:
	std::unique_ptr<std::uint8_t, decltype(&std::free)> stamps_;
	std::size_t cells_;
	std::uint8_t slice_ = 0;
};

// Marks for one block, lent to sheets in flight and taken back: as many exist as were in flight at once.
class VisitedPool
{
public:
	explicit VisitedPool(std::size_t cells) : cells_(cells) {}

	using Loan = std::unique_ptr<VisitedMarks, std::function<void(VisitedMarks*)>>;

	Loan borrow();
	std::size_t bytes() const; // held by all marks of the pool

private:
	std::size_t cells_;
	mutable std::mutex mutex_;
	std::vector<std::unique_ptr<VisitedMarks>> idle_;
	std::size_t made_ = 0;
};

} // namespace vp::traverse
