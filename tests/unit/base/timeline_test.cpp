#include "base/frame_scope.h"
#include "base/parallel_for.h"
#include "base/section_use.h"
#include "base/timeline.h"
#include "base/worker_piece.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include <sys/mman.h>
#include <unistd.h>

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

TEST(SectionUse, CpuTimeOfSections)
{
	Timeline timeline;
	std::optional<SectionMeter> meter;
	{
		const TimedSection before(&timeline, "before"); // it begins before times are counted
		meter.emplace();
	}
	EXPECT_TRUE(meter->take().empty());
	{
		const TimedSection outer(&timeline, "outer");
		for (int k = 0; k < 2; ++k)
		{
			const TimedSection rest(&timeline, "rest");
			std::this_thread::sleep_for(std::chrono::milliseconds(20));
		}
		const TimedSection work(&timeline, "work");
		for (const double start = timeline.now(); timeline.now() < start + 20.0;)
			;
	}
	const SectionUses uses = meter->take();
	ASSERT_EQ(uses.size(), 3u);
	EXPECT_LT(uses.at("rest").cpu_ms, 5.0); // in 40 ms
	EXPECT_GT(uses.at("work").cpu_ms, 0.5); // in 20 ms, in which others may have had the core
	EXPECT_GE(uses.at("outer").cpu_ms, uses.at("work").cpu_ms);
	{
		const TimedSection after(&timeline, "after"); // it ends when times are no longer counted
		meter.reset();
	}
	EXPECT_TRUE(SectionMeter().take().empty());
}

TEST(SectionUse, PageFaultsOfNewMemory)
{
	constexpr std::size_t kPages = 300;
	const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
	Timeline timeline;
	SectionMeter meter;
	void* memory = mmap(nullptr, kPages * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
	ASSERT_NE(memory, MAP_FAILED);
	madvise(memory, kPages * page, MADV_NOHUGEPAGE);
	for (const char* name : {"new", "again"})
	{
		const TimedSection section(&timeline, name);
		for (std::size_t i = 0; i < kPages; ++i)
			static_cast<volatile char*>(memory)[i * page] = 1;
	}
	munmap(memory, kPages * page);
	const SectionUses uses = meter.take();
	EXPECT_GE(uses.at("new").page_faults, double(kPages));
	EXPECT_LT(uses.at("new").page_faults, 6.0 * kPages); // a sanitizer keeps memory of its own for each page
	EXPECT_LT(uses.at("again").page_faults, 0.5 * kPages);
}

// Where the processor's counters are there, they see what a loop does; where not, a line says why.
TEST(SectionUse, InstructionsOrAReason)
{
	constexpr unsigned kRounds = 1'000'000;
	Timeline timeline;
	SectionMeter meter;
	{
		const TimedSection section(&timeline, "loop");
		volatile unsigned sum = 0;
		for (unsigned i = 0; i < kRounds; ++i)
			sum = sum + i;
	}
	const SectionUse use = meter.take().at("loop");
	if (meter.whyNoCounters().empty())
	{
		EXPECT_GT(use.instructions, 3.0 * kRounds); // load, add, store
		EXPECT_LT(use.instructions, 100.0 * kRounds);
	}
	else
	{
		EXPECT_EQ(use.instructions, 0.0);
		EXPECT_EQ(use.cache_misses, 0.0);
		EXPECT_GT(meter.whyNoCounters().size(), 20u) << meter.whyNoCounters();
	}
}

TEST(Timeline, TraceHoldsWorkersApart)
{
	if (tbb::info::default_concurrency() < 2)
		GTEST_SKIP() << "one core: TBB starts no workers";
	Timeline timeline(Timeline::Keep::trace);
	const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 2);
	{
		const TimedSection section(&timeline, "work");
		// A part waits until another thread has taken one, so that a worker must come.
		std::atomic<int> begun = 0;
		tracedFor(std::size_t(0), std::size_t(2),
		          [&](std::size_t)
		          {
			          ++begun;
			          for (const double start = timeline.now(); begun < 2 && timeline.now() < start + 20e3;)
				          std::this_thread::yield();
		          });
	}
	const auto sections = timeline.takeSections();
	std::vector<Timeline::Section> pieces;
	std::ranges::copy_if(sections, std::back_inserter(pieces),
	                     [](const auto& section) { return section.track == Timeline::Track::worker; });
	ASSERT_EQ(pieces.size(), 1u);
	ASSERT_EQ(sections.size(), 2u);
	const Timeline::Section& whole = sections[0].track == Timeline::Track::cpu ? sections[0] : sections[1];
	EXPECT_EQ(pieces[0].name, "work");
	EXPECT_NE(pieces[0].row, whole.row);
	EXPECT_TRUE(rowName(pieces[0].row).starts_with("worker ")) << rowName(pieces[0].row);
	EXPECT_GE(pieces[0].start_ms, whole.start_ms);
	EXPECT_LE(pieces[0].start_ms + pieces[0].duration_ms, whole.start_ms + whole.duration_ms);
	EXPECT_EQ(timeline.total("work"), whole.duration_ms); // pieces are not summed
	EXPECT_EQ(timeline.total("work", Timeline::Track::worker), 0.0);
}

TEST(Timeline, PiecesThatFollowEachOtherAreOne)
{
	Timeline timeline(Timeline::Keep::trace);
	timeline.addPiece("a", 7, 1.0, 2.0);
	timeline.addPiece("a", 7, 2.001, 3.0);
	timeline.addPiece("a", 8, 2.5, 2.75); // another worker
	timeline.addPiece("a", 7, 3.5, 4.0);  // after a pause
	timeline.addPiece("b", 7, 4.0, 5.0);
	auto sections = timeline.takeSections();
	std::ranges::sort(sections, {}, &Timeline::Section::start_ms);
	ASSERT_EQ(sections.size(), 4u);
	EXPECT_EQ(sections[0].duration_ms, 2.0);
	EXPECT_EQ(sections[1].row, 8u);
	EXPECT_EQ(sections[2].start_ms, 3.5);
	EXPECT_EQ(sections[3].name, "b");
	EXPECT_TRUE(timeline.takeSections().empty());
}

TEST(Timeline, OnlyATraceHasMarksAndSetup)
{
	for (const auto keep : {Timeline::Keep::totals, Timeline::Keep::sections, Timeline::Keep::trace})
	{
		Timeline timeline(keep);
		const bool traces = keep == Timeline::Keep::trace;
		{
			const TimedSection section(&timeline, "cut");
			EXPECT_EQ(Timeline::tracingHere(), traces ? &timeline : nullptr);
			EXPECT_EQ(TracedLoop().timeline(), Timeline::tracingHere());
			const TimedSection setup(&timeline, "pipeline layer", 0, Timeline::Track::setup);
			timeline.count("front", 3);
			timeline.addPiece("cut", 1, 0.0, 1.0);
		}
		EXPECT_EQ(Timeline::tracingHere(), nullptr);
		std::size_t fronts = 0;
		std::size_t resident = 0;
		for (const Timeline::Mark& mark : timeline.takeMarks())
		{
			fronts += std::string_view(mark.name) == "front" && mark.value == 3;
			resident += std::string_view(mark.name) == "resident memory" && mark.value > 1'000'000;
		}
		EXPECT_EQ(fronts, traces ? 1u : 0u);
		EXPECT_EQ(resident > 0, traces); // at most one a millisecond
		EXPECT_EQ(timeline.takeSections().size(), traces ? 3u : keep == Timeline::Keep::sections ? 1u : 0u);
		EXPECT_EQ(timeline.total("pipeline layer"), 0.0);
	}
}

TEST(Timeline, FramesFlowFromStopToStop)
{
	using Stop = FrameScope::Stop;
	using Kind = Timeline::Mark::Kind;
	Timeline timeline(Timeline::Keep::trace);
	FrameScope::comesTo(Stop::cut, &timeline); // there is no frame
	{
		const FrameScope still(3, Stop::file); // it is not cut
		FrameScope::comesTo(Stop::picture, &timeline);
		FrameScope::comesTo(Stop::file, &timeline);
	}
	{
		const FrameScope figures(4, Stop::cut); // nothing follows the cut
		FrameScope::comesTo(Stop::cut, &timeline);
	}
	{
		const FrameScope frame(5, Stop::file);
		const TimedSection section(&timeline, "frame");
		FrameScope::comesTo(Stop::cut, &timeline);
		const FrameScope inner(5, Stop::file);
		FrameScope::comesTo(Stop::picture, &timeline);
		FrameScope::comesTo(Stop::file, &timeline);
		FrameScope::comesTo(Stop::file, &timeline); // it has ended
	}
	EXPECT_EQ(FrameScope::frame(), Timeline::kNoFrame);
	std::vector<Kind> kinds;
	for (const Timeline::Mark& mark : timeline.takeMarks())
		if (mark.kind != Kind::counter)
		{
			EXPECT_EQ(mark.value, 5u);
			EXPECT_EQ(mark.row, threadRow());
			kinds.push_back(mark.kind);
		}
	EXPECT_EQ(kinds, (std::vector{Kind::flow_begin, Kind::flow_step, Kind::flow_end}));
	const auto sections = timeline.takeSections();
	ASSERT_EQ(sections.size(), 1u);
	EXPECT_EQ(sections[0].frame, 5);
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
