#include "base/timeline.h"

#include <gtest/gtest.h>

#include <thread>

namespace vp::test
{

TEST(Timeline, SumsSectionsByNameAndTrack)
{
	Timeline timeline;
	timeline.add("cut", Timeline::Track::cpu, 0.0, 2.0);
	timeline.add("cut", Timeline::Track::cpu, 5.0, 3.0);
	timeline.add("cut", Timeline::Track::gpu, 1.0, 10.0);
	timeline.add("draw", Timeline::Track::gpu, 1.0, 20.0);
	EXPECT_EQ(timeline.total("cut"), 5.0);
	EXPECT_EQ(timeline.total("cut", Timeline::Track::gpu), 10.0);
	EXPECT_EQ(timeline.total("none"), 0.0);
	EXPECT_EQ(timeline.totalGpu(), 30.0);
	ASSERT_EQ(timeline.sections().size(), 4u);
	EXPECT_EQ(timeline.sections()[1].start_ms, 5.0);
}

TEST(Timeline, MeasuresAScope)
{
	Timeline timeline;
	const double before = timeline.now();
	{
		const TimedSection section(&timeline, "work");
		std::this_thread::sleep_for(std::chrono::milliseconds(5));
	}
	ASSERT_EQ(timeline.sections().size(), 1u);
	const Timeline::Section section = timeline.sections()[0];
	EXPECT_EQ(section.name, "work");
	EXPECT_EQ(section.track, Timeline::Track::cpu);
	EXPECT_GE(section.start_ms, before);
	EXPECT_GE(section.duration_ms, 5.0);
	EXPECT_LE(section.start_ms + section.duration_ms, timeline.now());
}

TEST(Timeline, NullMeasuresNothing)
{
	const TimedSection section(nullptr, "nothing");
}

TEST(Timeline, ManyThreadsMayAdd)
{
	Timeline timeline;
	std::vector<std::thread> threads;
	for (int t = 0; t < 4; ++t)
		threads.emplace_back(
		    [&]
		    {
			    for (int i = 0; i < 500; ++i)
				    timeline.add("part", Timeline::Track::cpu, timeline.now(), 1.0);
		    });
	for (std::thread& thread : threads)
		thread.join();
	EXPECT_EQ(timeline.total("part"), 2000.0);
}

} // namespace vp::test
