#include "base/parallel_reduce.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <numeric>
#include <vector>

namespace vp::test
{

namespace
{

constexpr std::size_t kCount = 100000;

// How many of the numbers were passed to the body, by ranges of a grain each where somebody may ask to stop.
std::size_t passedInRanges(std::size_t grain)
{
	std::vector<std::uint8_t> seen(kCount);
	parallelFor(tbb::blocked_range<std::size_t>(0, kCount, grain),
	            [&](const tbb::blocked_range<std::size_t>& range)
	            {
		            EXPECT_TRUE(!StopScope::current() || range.size() <= grain);
		            for (std::size_t i = range.begin(); i < range.end(); ++i)
			            ++seen[i];
	            });
	EXPECT_TRUE(std::ranges::all_of(seen, [](std::uint8_t times) { return times == 1; }));
	return std::accumulate(seen.begin(), seen.end(), std::size_t(0));
}

} // namespace

TEST(ParallelFor, PassesEachNumberOnceWithAndWithoutAScope)
{
	for (const std::size_t grain : {1u, 7u, 4096u, 1000000u})
	{
		EXPECT_EQ(passedInRanges(grain), kCount);
		const std::stop_source source;
		const StopScope scope(source.get_token());
		EXPECT_EQ(passedInRanges(grain), kCount);
	}
	std::atomic<std::size_t> sum = 0;
	parallelFor(std::size_t(1), std::size_t(101), [&](std::size_t i) { sum += i; });
	EXPECT_EQ(sum, 5050u);
}

TEST(ParallelFor, EndsSoonAfterARequest)
{
	std::stop_source source;
	std::atomic<std::size_t> passed = 0;
	const auto work = [&]() -> Result<int>
	{
		parallelFor(tbb::blocked_range<std::size_t>(0, kCount, 10),
		            [&](const tbb::blocked_range<std::size_t>& range)
		            {
			            if (passed.fetch_add(range.size()) > 1000)
				            source.request_stop();
		            });
		return 1;
	};
	const Result<int> stopped = endingOnRequest(source.get_token(), "counting", work);
	ASSERT_FALSE(stopped);
	EXPECT_EQ(stopped.error().kind, ErrorKind::cancelled);
	EXPECT_EQ(stopped.error().message, "counting was cancelled");
	EXPECT_LT(passed, kCount / 2);
	EXPECT_EQ(StopScope::current(), nullptr);

	passed = 0;
	const auto each = [&]() -> Result<int> { return parallelFor(0, 1000, [&](int) { ++passed; }), 1; };
	EXPECT_FALSE(endingOnRequest(source.get_token(), "counting", each));
	EXPECT_EQ(passed, 0u);
	EXPECT_TRUE(endingOnRequest({}, "counting", each)); // nobody can ask
	EXPECT_EQ(passed, 1000u);
}

// Sums of such numbers depend on the order of adding.
TEST(ParallelReduce, TakesAllAndJoinsInOrderForAnyNumberOfThreads)
{
	const auto sumOf = [](std::size_t count, std::size_t grain)
	{
		std::vector<std::atomic<int>> seen(count);
		const auto take = [&](const tbb::blocked_range<std::size_t>& range, double sum)
		{
			EXPECT_TRUE(range.size() >= grain || range.end() == count);
			for (std::size_t i = range.begin(); i < range.end(); ++i)
			{
				++seen[i];
				sum += 1.0 / static_cast<double>(3 * i + 1);
			}
			return sum;
		};
		const double sum = parallelReduce(count, grain, 0.0, take, std::plus<>());
		EXPECT_TRUE(std::ranges::all_of(seen, [](const auto& times) { return times == 1; }));
		return sum;
	};
	for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 100000u})
		for (const std::size_t grain : {1u, 7u, 4096u})
		{
			const double sum = sumOf(count, grain);
			const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
			EXPECT_EQ(sumOf(count, grain), sum);
		}
	EXPECT_EQ(sumOf(2, 1), 1.0 + 0.25);
	// A flag for each part, which threads set at once.
	EXPECT_FALSE(parallelReduce(
	    kCount, 1, true, [](const auto& range, bool so_far) { return so_far && range.begin() == 0; },
	    std::logical_and<>()));
}

TEST(ParallelFor, ScopesLieWithinEachOther)
{
	std::stop_source outer;
	const StopScope scope(outer.get_token());
	outer.request_stop();
	{
		const std::stop_source inner;
		const StopScope within(inner.get_token());
		EXPECT_NO_THROW(throwIfStopped());
	}
	EXPECT_THROW(throwIfStopped(), Stopped);
}

} // namespace vp::test
