#include "base/timeline.h"

#include <gtest/gtest.h>

#include <thread>

namespace vp::test
{

TEST(Timeline, SumsSectionsByNameAndTrack)
{
	Timeline timeline(Timeline::Keep::sections);
	timeline.add("cut", Timeline::Track::cpu, 0.0, 2.0);
	timeline.add("cut", Timeline::Track::cpu, 5.0, 3.0);
	timeline.add("cut", Timeline::Track::gpu, 1.0, 10.0);
	timeline.add("draw", Timeline::Track::gpu, 1.0, 20.0);
	EXPECT_EQ(timeline.total("cut"), 5.0);
	EXPECT_EQ(timeline.total("cut", Timeline::Track::gpu), 10.0);
	EXPECT_EQ(timeline.total("none"), 0.0);
	EXPECT_EQ(timeline.totalGpu(), 30.0);
	const auto sections = timeline.takeSections();
	ASSERT_EQ(sections.size(), 4u);
	EXPECT_EQ(sections[1].start_ms, 5.0);
	EXPECT_TRUE(timeline.takeSections().empty());
	EXPECT_EQ(timeline.total("cut"), 5.0); // sums stay
}

// A long sweep must not fill the memory.
TEST(Timeline, KeepsNoSectionsUnasked)
{
	Timeline timeline;
	timeline.add("cut", Timeline::Track::cpu, 0.0, 2.0);
	EXPECT_TRUE(timeline.takeSections().empty());
	EXPECT_EQ(timeline.total("cut"), 2.0);
}

TEST(Timeline, MeasuresAScope)
{
	Timeline timeline(Timeline::Keep::sections);
	const double before = timeline.now();
	{
		const TimedSection section(&timeline, "work", 7);
		std::this_thread::sleep_for(std::chrono::milliseconds(5));
	}
	const auto sections = timeline.takeSections();
	ASSERT_EQ(sections.size(), 1u);
	const Timeline::Section& section = sections[0];
	EXPECT_EQ(section.cells, 7u);
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

TEST(Timeline, SectionsKnowTheirRowAndDepth)
{
	Timeline timeline(Timeline::Keep::sections);
	{
		const TimedSection outer(&timeline, "outer");
		const TimedSection unmeasured(nullptr, "nothing");
		const TimedSection inner(&timeline, "inner");
		std::thread(
		    [&]
		    {
			    nameThreadRow("helper");
			    const TimedSection beside(&timeline, "beside");
		    })
		    .join();
	}
	const auto sections = timeline.takeSections();
	ASSERT_EQ(sections.size(), 3u); // in the order of their ends
	EXPECT_EQ(sections[0].name, "beside");
	EXPECT_EQ(sections[0].depth, 0u);
	EXPECT_EQ(rowName(sections[0].row), "helper");
	EXPECT_EQ(sections[1].name, "inner");
	EXPECT_EQ(sections[1].depth, 1u);
	EXPECT_EQ(sections[2].depth, 0u);
	EXPECT_EQ(sections[1].row, threadRow());
	EXPECT_EQ(sections[2].row, threadRow());
	EXPECT_NE(sections[0].row, threadRow());
	const std::uint32_t added = addRow("elsewhere");
	EXPECT_EQ(rowName(added), "elsewhere");
	EXPECT_EQ(rowName(added + 1), "thread " + std::to_string(added + 1));
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
