#include "trace_check.h"

#include "write/trace_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace vp::test
{

namespace
{

class TraceFile : public testing::Test
{
protected:
	~TraceFile() override { std::filesystem::remove(path_); }

	// Returns the contents of the file, which are checked against the format.
	trace::Rows written(std::vector<std::vector<Timeline::Section>> batches,
	                    const std::vector<Timeline::Mark>& marks = {})
	{
		Result<write::TraceFile> file = write::TraceFile::create(path_);
		EXPECT_TRUE(file);
		file->describe("command_line", "render \"a\\b\" \xff");
		for (auto& batch : batches)
			file->add(std::move(batch), &batch == &batches.front() ? marks : std::vector<Timeline::Mark>());
		EXPECT_TRUE(file->commit());
		std::ostringstream text;
		text << std::ifstream(path_).rdbuf();
		return trace::check(text.str());
	}

	const std::string path_ = testing::TempDir() + "trace-" + std::to_string(getpid()) + ".json";
};

Timeline::Section section(const char* name, double start, double end, std::uint32_t row, std::uint32_t depth = 0)
{
	return {name, Timeline::Track::cpu, start, end - start, row, depth};
}

} // namespace

TEST_F(TraceFile, EmptyIsATraceToo)
{
	EXPECT_TRUE(written({}).events.empty());
}

TEST_F(TraceFile, PartsAndRestAddUp)
{
	const std::uint32_t row = addRow("worker");
	// As they end: inner ones first; the outermost comes in a later batch.
	const trace::Rows rows = written({{section("seed", 1.0, 2.0, row, 1), section("classify", 3.0, 3.5, row, 2)},
	                                  {section("traverse", 2.0, 4.0, row, 1), section("cut", 0.5, 5.0, row)}});
	const std::vector<trace::Event>& events = rows.named("worker");
	const std::vector<std::string> names{"cut", "other", "seed", "traverse", "other", "classify", "other", "other"};
	ASSERT_EQ(events.size(), names.size());
	for (std::size_t i = 0; i < names.size(); ++i)
		EXPECT_EQ(events[i].name, names[i]) << i;
	EXPECT_EQ(events[0].begin, 500'000);
	EXPECT_EQ(events[0].end, 5'000'000);
	EXPECT_EQ(events[6].begin, 3'500'000); // begin of traverse
	EXPECT_EQ(events[6].end, 4'000'000);
	EXPECT_EQ(events[7].begin, 4'000'000); // begin of cut
	EXPECT_EQ(events[7].end, 5'000'000);
	for (const std::size_t whole : {0, 3})
	{
		std::int64_t sum = 0;
		for (const trace::Event& part : trace::partsOf(events, events[whole]))
			sum += part.end - part.begin;
		EXPECT_EQ(sum, events[whole].end - events[whole].begin) << whole;
	}
}

TEST_F(TraceFile, SectionsWithoutPartsHaveNoRest)
{
	const std::uint32_t row = addRow("worker");
	EXPECT_EQ(written({{section("read", 0.0, 5.0, row), section("build", 6.0, 7.0, row)}}).named("worker").size(), 2u);
}

// The device's clock is held against ours more than once, and sections of one queue may seem to overlap by a little.
TEST_F(TraceFile, ClocksThatDifferALittleDoNotMakeSectionsOverlap)
{
	const std::uint32_t row = addRow("GPU");
	std::vector<Timeline::Section> passes{section("layers", 1.0, 2.0, row), section("compose", 1.9, 3.0, row),
	                                      section("inner", 2.1, 2.2, row), section("copy", 2.9999, 3.0001, row)};
	for (Timeline::Section& pass : passes)
		pass.track = Timeline::Track::gpu;
	const auto rows = written({{passes[0]}, {passes[1], passes[2]}, {passes[3]}});
	const auto& events = rows.named("GPU");
	ASSERT_EQ(events.size(), 4u);
	EXPECT_EQ(events[1].name, "compose");
	EXPECT_EQ(events[1].category, "gpu");
	EXPECT_EQ(events[1].begin, 2'000'000);
	EXPECT_EQ(events[1].end, 3'000'000);
	EXPECT_EQ(events[2].begin, 2'100'000);
}

TEST_F(TraceFile, CellsOfAFrontAreTold)
{
	Timeline::Section front = section("classify", 0.0, 1.0, addRow("cells"));
	front.cells = 123'456;
	EXPECT_EQ(written({{front}}).named("cells").at(0).cells, 123'456u);
}

TEST_F(TraceFile, RealSectionsOfSeveralThreads)
{
	Timeline timeline(Timeline::Keep::sections);
	const auto work = [&](const char* name)
	{
		nameThreadRow(name);
		for (int frame = 0; frame < 200; ++frame)
		{
			const TimedSection whole(&timeline, "frame");
			for (const char* part : {"seed", "traverse", "emit"})
			{
				const TimedSection outer(&timeline, part);
				const TimedSection inner(&timeline, "inner");
				std::this_thread::yield();
			}
		}
	};
	std::thread other(work, "other thread");
	std::thread another(work, "another thread");
	other.join();
	another.join();
	const trace::Rows rows = written({timeline.takeSections()});
	for (const char* row : {"other thread", "another thread"})
	{
		const auto& events = rows.named(row);
		EXPECT_GE(events.size(), 200u * 7);
		for (const trace::Event& event : events)
			if (event.name == "frame")
				trace::expectWhole(events, event);
	}
}

TEST_F(TraceFile, CountersFlowsFramesAndWhatItIsOf)
{
	using Kind = Timeline::Mark::Kind;
	const std::uint32_t cutter = addRow("cutter");
	const std::uint32_t painter = addRow("painter \"2\"");
	std::vector<Timeline::Section> sections{section("seed", 1.2, 1.8, cutter, 1), section("cut", 1.0, 2.0, cutter),
	                                        section("render", 3.0, 4.0, painter)};
	sections[1].frame = sections[2].frame = 7;
	const trace::Rows rows = written({sections}, {{Kind::flow_begin, "frame", 1.1, 7, cutter},
	                                              {Kind::counter, "front", 1.3, 41},
	                                              {Kind::counter, "front", 1.4, 0},
	                                              {Kind::flow_end, "frame", 3.5, 7, painter}});
	EXPECT_EQ(rows.named("cutter").at(0).frame, 7);
	EXPECT_EQ(rows.named("cutter").at(2).name, "seed"); // behind the rest before it
	EXPECT_EQ(rows.named("cutter").at(2).frame, -1);
	EXPECT_EQ(rows.named("painter \"2\"").at(0).frame, 7);
	ASSERT_EQ(rows.flows.size(), 1u);
	const std::vector<trace::FlowPoint>& flow = rows.flows.at(7);
	ASSERT_EQ(flow.size(), 2u);
	EXPECT_EQ(flow[0].event, "cut");
	EXPECT_EQ(flow[1].event, "render");
	EXPECT_EQ(flow[1].row, "painter \"2\"");
	ASSERT_EQ(rows.counters.at("front").size(), 2u);
	EXPECT_EQ(rows.counters.at("front")[0].at, 1'300'000);
	EXPECT_EQ(rows.counters.at("front")[0].value, 41u);
	EXPECT_EQ(rows.counters.at("front")[1].value, 0u);
	EXPECT_EQ(rows.about.at("command_line"), "render \"a\\b\" \uFFFD");
}

TEST_F(TraceFile, WorkersAndPipelinesHaveCategoriesOfTheirOwn)
{
	std::vector<Timeline::Section> sections{section("traverse", 1.0, 2.0, addRow("worker")),
	                                        section("pipeline layer", 1.0, 2.0, addRow("device"))};
	sections[0].track = Timeline::Track::worker;
	sections[1].track = Timeline::Track::setup;
	const trace::Rows rows = written({sections});
	EXPECT_EQ(rows.named("worker").at(0).category, "worker");
	EXPECT_EQ(rows.named("device").at(0).category, "setup");
}

TEST_F(TraceFile, PlaceThatCannotBeIsTold)
{
	const Result<write::TraceFile> file = write::TraceFile::create("/dev/null/trace.json");
	ASSERT_FALSE(file);
	EXPECT_NE(file.error().message.find("/dev/null/trace.json"), std::string::npos);
}

} // namespace vp::test
