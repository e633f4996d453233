#include "wrapped_grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stop_token>

namespace face
{

namespace
{

std::size_t entriesOf(const char* folder)
{
	std::size_t entries = 0;
	for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder))
		++entries;
	return entries;
}

// How many pixels are not the background's.
std::size_t drawn(const vprobe::Image& image)
{
	std::size_t count = 0;
	for (std::size_t i = 0; i < image.rgba.size(); i += 4)
		count += image.rgba[i] != 255 || image.rgba[i + 1] != 255 || image.rgba[i + 2] != 255;
	return count;
}

} // namespace

TEST(Picture, TenDataSetsAreDrawnAndLeaveNothingOpen)
{
	const Box box(6);
	std::size_t descriptors = 0;
	std::size_t tasks = 0;
	for (int round = 0; round < 10; ++round)
	{
		{
			const auto data = vprobe::Dataset::wrap({box.unstructured()});
			ASSERT_TRUE(data);
			const auto image = data->render(onWhite());
			if (!image && image.error().kind == vprobe::ErrorKind::device)
				GTEST_SKIP() << image.error().message;
			ASSERT_TRUE(image) << image.error().message;
			EXPECT_EQ(image->rgba.size(), 4u * 320u * 200u);
			EXPECT_GT(drawn(*image), 2000u);
		}
		if (round == 1) // drivers and oneTBB have what they keep by then
		{
			descriptors = entriesOf("/proc/self/fd");
			tasks = entriesOf("/proc/self/task");
		}
	}
	EXPECT_LE(entriesOf("/proc/self/fd"), descriptors);
	EXPECT_LE(entriesOf("/proc/self/task"), tasks + 1);
}

TEST(Picture, DrawingEndsOnRequest)
{
	const Box box(6);
	const auto data = vprobe::Dataset::wrap({box.structured()});
	ASSERT_TRUE(data);
	const auto cut = data->cut(onWhite());
	ASSERT_TRUE(cut);
	const auto before = data->render(*cut, onWhite());
	if (!before && before.error().kind == vprobe::ErrorKind::device)
		GTEST_SKIP() << before.error().message;
	ASSERT_TRUE(before) << before.error().message;
	std::stop_source stop;
	const auto undisturbed = data->render(*cut, onWhite(), stop.get_token()); // sample by sample
	ASSERT_TRUE(undisturbed);
	EXPECT_EQ(undisturbed->rgba, before->rgba);
	stop.request_stop();
	const auto stopped = data->render(*cut, onWhite(), stop.get_token());
	ASSERT_FALSE(stopped);
	EXPECT_EQ(stopped.error().kind, vprobe::ErrorKind::cancelled);
	const auto after = data->render(*cut, onWhite());
	ASSERT_TRUE(after);
	EXPECT_EQ(after->rgba, before->rgba);
}

TEST(Picture, ACutIsDrawnAsItsOwnPicture)
{
	const Box box(6);
	const auto data = vprobe::Dataset::wrap({box.unstructured()});
	ASSERT_TRUE(data);
	const vprobe::View view = onWhite();
	const auto cut = data->cut(view);
	ASSERT_TRUE(cut);
	const auto first = data->render(*cut, view);
	if (!first && first.error().kind == vprobe::ErrorKind::device)
		GTEST_SKIP() << first.error().message;
	ASSERT_TRUE(first) << first.error().message;
	ASSERT_TRUE(data->cut(view)); // links the cells
	const auto second = data->render(*cut, view);
	ASSERT_TRUE(second) << second.error().message;
	EXPECT_EQ(first->rgba, second->rgba);
	EXPECT_EQ(data->render(view)->rgba, first->rgba);
	// A cut of another view, or of another data set, is not what is drawn.
	vprobe::View other = view;
	other.crinkle(true);
	EXPECT_EQ(data->render(*cut, other)->rgba, data->render(other)->rgba);
	const auto stranger = vprobe::Dataset::wrap({Box(2).image()});
	EXPECT_FALSE(vprobe::Image().png());
	EXPECT_EQ(data->render(*stranger->cut(view), view)->rgba, first->rgba);
	EXPECT_EQ(first->png()->substr(1, 3), "PNG");

	vprobe::View sweep = view;
	ASSERT_TRUE(sweep.set("frames", "3"));
	std::vector<vprobe::Image> frames;
	const auto swept = data->sweep(
	    sweep,
	    [&](const vprobe::SweepFrame& frame)
	    {
		    frames.push_back(frame.image);
		    return true;
	    },
	    true);
	ASSERT_TRUE(swept) << swept.error().message;
	ASSERT_EQ(frames.size(), 3u);
	EXPECT_NE(frames[0].rgba, frames[1].rgba);
	EXPECT_FALSE(vprobe::Image().save("none.png"));
}

} // namespace face
