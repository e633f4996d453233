#include "find/visited.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace vp::test
{

using find::VisitedMarks;
using find::VisitedPool;

TEST(VisitedMarks, MarkOnceASlice)
{
	VisitedMarks marks(10);
	for (int slice = 0; slice < 700; ++slice) // past the wrap of a byte, twice
	{
		marks.beginCut();
		// Cell 3 only now and then, so that old stamps wait for the number to come round.
		for (const CellId cell : {CellId(0), CellId(9), slice % 256 == 100 ? CellId(3) : CellId(5)})
		{
			ASSERT_TRUE(marks.mark(cell)) << slice;
			ASSERT_FALSE(marks.mark(cell)) << slice;
		}
	}
}

TEST(VisitedMarks, AnOldStampIsNeverMistaken)
{
	VisitedMarks marks(1000);
	for (CellId cell = 0; cell < 1000; ++cell) // each cell is marked in one slice of its own
	{
		marks.beginCut();
		ASSERT_TRUE(marks.mark(cell));
	}
	for (int slice = 0; slice < 256; ++slice)
	{
		marks.beginCut();
	}
	for (CellId cell = 0; cell < 1000; ++cell)
		ASSERT_TRUE(marks.mark(cell)) << cell;
}

TEST(VisitedPool, LendsAndTakesBack)
{
	VisitedPool pool(100);
	{
		const VisitedPool::Loan first = pool.borrow();
		const VisitedPool::Loan second = pool.borrow();
		EXPECT_NE(first.get(), second.get());
		EXPECT_EQ(pool.bytes(), 200u);
		EXPECT_TRUE(first->mark(7));
		EXPECT_TRUE(second->mark(7)); // sheets cross in the same cells
	}
	const VisitedPool::Loan again = pool.borrow();
	EXPECT_EQ(pool.bytes(), 200u);
	EXPECT_TRUE(again->mark(7)); // a slice of its own
}

TEST(VisitedPool, ServesManyThreads)
{
	VisitedPool pool(50);
	std::vector<std::thread> threads;
	for (int t = 0; t < 4; ++t)
		threads.emplace_back(
		    [&]
		    {
			    for (int i = 0; i < 400; ++i)
			    {
				    const VisitedPool::Loan marks = pool.borrow();
				    for (CellId cell = 0; cell < 50; ++cell)
					    EXPECT_TRUE(marks->mark(cell));
			    }
		    });
	for (std::thread& thread : threads)
		thread.join();
	EXPECT_LE(pool.bytes(), 4u * 50u);
}

TEST(VisitedPool, AnEmptyBlockHasMarksToo)
{
	VisitedPool pool(0);
	EXPECT_TRUE(pool.borrow());
	EXPECT_EQ(pool.bytes(), 0u);
}

} // namespace vp::test
