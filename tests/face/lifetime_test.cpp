#include "wrapped_grids.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <stop_token>
#include <thread>

namespace face
{

namespace
{

using vprobe::Dataset;
using vprobe::View;

std::size_t entriesOf(const char* folder)
{
	std::size_t entries = 0;
	for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder))
		++entries;
	return entries;
}

vprobe::Field owned(const std::shared_ptr<const std::vector<double>>& values)
{
	return {"value", vprobe::Association::point, 1, vprobe::Numbers(values)};
}

} // namespace

TEST(Lifetime, OwnersLiveAsLongAsTheyAreNeeded)
{
	const Box box(4);
	auto values = std::make_shared<const std::vector<double>>(box.value);
	const std::weak_ptr<const std::vector<double>> watched = values;
	vprobe::Block block = box.image();
	block.fields = {owned(values)};
	values.reset();
	std::optional<vprobe::Mesh> mesh;
	{
		std::optional<vprobe::Cut> cut;
		{
			const auto data = Dataset::wrap({std::move(block)}, vprobe::Classify::cpu);
			ASSERT_TRUE(data);
			const auto made = data->cut(View().normal({1.0, 1.0, 1.0}));
			ASSERT_TRUE(made);
			cut = *made;
		}
		EXPECT_FALSE(watched.expired()); // the cut may still be asked for its arrays
		mesh = cut->mesh(0);
	}
	EXPECT_GT(mesh->array("value")->tuples, 0u);
	EXPECT_FALSE(watched.expired());
	mesh.reset();
	EXPECT_TRUE(watched.expired());
}

// A cut that was made before neighbors were known keeps the cells as they were numbered then.
TEST(Lifetime, ACutOutlivesTheLinkingOfItsCells)
{
	const Box box(6);
	const auto data = Dataset::wrap({box.unstructured()}, vprobe::Classify::cpu);
	ASSERT_TRUE(data);
	EXPECT_FALSE(data->memory().copied);
	const auto first = data->cut(View().normal({0.3, 0.5, 0.8}));
	ASSERT_TRUE(first);
	EXPECT_FALSE(data->memory().copied) << "the first cut looks at every cell once";
	const auto second = data->cut(View().normal({0.3, 0.5, 0.8}));
	ASSERT_TRUE(second);
	EXPECT_TRUE(data->memory().copied);
	EXPECT_GT(data->memory().built, 0u);
	EXPECT_NEAR(first->figures(0).area, second->figures(0).area, 1e-12);
	for (const vprobe::Cut* cut : {&*first, &*second})
	{
		const vprobe::Mesh mesh = cut->mesh(0);
		for (std::size_t i = 0; i < mesh.polygonCount(); ++i)
			EXPECT_EQ(mesh.array("number")->value(i), static_cast<double>(mesh.cells()[i]));
	}
}

TEST(Lifetime, ValuesThatAreChangedInPlaceAreSeen)
{
	Box box(4);
	auto data = Dataset::wrap({box.image()}, vprobe::Classify::cpu);
	ASSERT_TRUE(data);
	const auto mean = [&] { return *data->cut(View().array("value"))->figures(0).mean; };
	const double before = mean();
	for (double& value : box.value)
		value *= 2.0;
	data->modified();
	EXPECT_NEAR(mean(), 2.0 * before, 1e-12);
}

// Figures are measured when they are asked for. Another interpolation between must not change them.
TEST(Lifetime, FiguresKeepTheInterpolationOfTheirCut)
{
	const Box box(6);
	const auto data = Dataset::wrap({box.image()}, vprobe::Classify::cpu);
	ASSERT_TRUE(data);
	const auto cutWith = [&](const char* interpolate)
	{
		View view;
		EXPECT_TRUE(view.array("value").normal({0.3, 0.5, 0.8}).set("interpolate", interpolate));
		return data->cut(view);
	};
	ASSERT_TRUE(cutWith("linear")); // the cuts that follow share the blocks
	const auto linear = cutWith("linear");
	ASSERT_TRUE(linear);
	const auto nearest = cutWith("nearest");
	ASSERT_TRUE(nearest);
	EXPECT_EQ(linear->figures(0).max, cutWith("linear")->figures(0).max);
	EXPECT_EQ(nearest->figures(0).max, cutWith("nearest")->figures(0).max);
	EXPECT_NE(linear->figures(0).max, nearest->figures(0).max);
}

TEST(Lifetime, TwoThreadsCutOneDataSet)
{
	const auto data = Dataset::open("demo:tets:8", {.classify = vprobe::Classify::cpu});
	ASSERT_TRUE(data) << data.error().message;
	const auto viewOf = [](int i) {
		return View().normal({0.3, 0.5, 0.1 * (i % 10)}).window(0.5 + 0.05 * (i % 7), 0.8);
	};
	std::vector<double> expected;
	for (int i = 0; i < 40; ++i)
		expected.push_back(data->cut(viewOf(i))->figures(0).area);
	std::atomic<int> wrong = 0;
	std::vector<std::thread> threads;
	for (int t = 0; t < 2; ++t)
		threads.emplace_back(
		    [&, t]
		    {
			    for (int i = t; i < 40; i += 2)
			    {
				    const auto cut = data->cut(viewOf(i));
				    wrong += !cut || std::abs(cut->figures(0).area - expected[static_cast<std::size_t>(i)]) > 1e-12;
			    }
		    });
	for (std::thread& thread : threads)
		thread.join();
	EXPECT_EQ(wrong, 0);
}

TEST(Lifetime, TenDataSetsLeaveNothingOpen)
{
	std::size_t descriptors = 0;
	std::size_t tasks = 0;
	for (int round = 0; round < 10; ++round)
	{
		{
			const auto data = Dataset::open("demo:mixed:6", {.classify = vprobe::Classify::cpu});
			ASSERT_TRUE(data);
			ASSERT_TRUE(data->cut(View().normal({0.3, 0.5, 0.8})));
			ASSERT_TRUE(data->cut(View().normal({0.3, 0.4, 0.8})));
		}
		if (round == 0)
		{
			descriptors = entriesOf("/proc/self/fd");
			tasks = entriesOf("/proc/self/task");
		}
	}
	EXPECT_LE(entriesOf("/proc/self/fd"), descriptors);
	EXPECT_LE(entriesOf("/proc/self/task"), tasks + 1); // oneTBB may start one more of its own
}

TEST(Lifetime, WhatIsStoppedIsCancelled)
{
	const auto data = Dataset::open("demo:shell:16", {.classify = vprobe::Classify::cpu});
	ASSERT_TRUE(data);
	std::stop_source stop;
	stop.request_stop();
	const auto cut = data->cut(View(), stop.get_token());
	ASSERT_FALSE(cut);
	EXPECT_EQ(cut.error().kind, vprobe::ErrorKind::cancelled);
	EXPECT_TRUE(data->cut(View())); // and the data set serves on
	vprobe::View sweep;
	ASSERT_TRUE(sweep.set("frames", "5"));
	std::stop_source later;
	int frames = 0;
	const auto swept = data->sweep(
	    sweep, [&](const vprobe::SweepFrame&) { return ++frames == 2 ? later.request_stop() : true; }, false,
	    later.get_token());
	ASSERT_FALSE(swept);
	EXPECT_EQ(swept.error().kind, vprobe::ErrorKind::cancelled);
	EXPECT_EQ(frames, 2);
	frames = 0;
	EXPECT_TRUE(data->sweep(sweep, [&](const vprobe::SweepFrame&) { return ++frames < 3; }));
	EXPECT_EQ(frames, 3);
}

TEST(Lifetime, NeighborsAndSamplesEndOnRequest)
{
	const face::Box box(24);
	std::stop_source stopped;
	stopped.request_stop();
	const auto wrapped = Dataset::wrap({box.unstructured()}, vprobe::Classify::cpu, {}, stopped.get_token());
	ASSERT_FALSE(wrapped);
	EXPECT_EQ(wrapped.error().kind, vprobe::ErrorKind::cancelled);
	const auto data = Dataset::wrap({box.unstructured()}, vprobe::Classify::cpu);
	ASSERT_TRUE(data);
	const std::vector<vprobe::Vector3> places(1000, {0.5, 0.5, 0.5});
	ASSERT_TRUE(data->cut(View()));
	for (int i = 0; i < 20; ++i)
	{
		std::stop_source stop;
		std::thread asks([&] { stop.request_stop(); });
		const auto cut = data->cut(View(), stop.get_token()); // which needs neighbors
		asks.join();
		if (!cut)
		{
			EXPECT_EQ(cut.error().kind, vprobe::ErrorKind::cancelled);
		}
		const auto samples = data->sample(places, {}, stop.get_token());
		ASSERT_FALSE(samples);
		EXPECT_EQ(samples.error().kind, vprobe::ErrorKind::cancelled);
	}
	const auto samples = data->sample(places);
	ASSERT_TRUE(samples);
	EXPECT_NEAR(samples->columns[0].values[7], 3.0, 1e-12);
	EXPECT_NEAR(data->cut(View())->figures(0).area, 1.0, 1e-12);
}

TEST(Lifetime, NothingIsPrintedAndMessagesAreHeard)
{
	testing::internal::CaptureStdout();
	testing::internal::CaptureStderr();
	std::vector<std::string> lines;
	std::vector<std::string> busy;
	{
		const vprobe::MessageListener messages([&](std::string_view line) { lines.emplace_back(line); });
		const vprobe::ProgressListener progress([&](std::string_view what) { busy.emplace_back(what); });
		const auto data = Dataset::open("demo:shell:8", {.classify = vprobe::Classify::cpu});
		ASSERT_TRUE(data);
		const auto cut = data->cut(View().origin({100.0, 0.0, 0.0}).normal({1.0, 0.0, 0.0}));
		ASSERT_TRUE(cut);
		EXPECT_EQ(cut->mesh(0).polygonCount(), 0u);
	}
	const auto none = Dataset::open("absent.vtu");
	EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
	ASSERT_FALSE(lines.empty());
	EXPECT_NE(lines[0].find("is empty"), std::string::npos);
	ASSERT_GE(busy.size(), 2u);
	EXPECT_EQ(busy.front(), "reading demo:shell:8");
	EXPECT_EQ(busy.back(), "");
	ASSERT_FALSE(none);
	EXPECT_EQ(none.error().kind, vprobe::ErrorKind::input);
	EXPECT_NE(none.error().message.find("absent.vtu"), std::string::npos);
}

} // namespace face
