#include "sample_slice.h"

#include "write/frame_names.h"

#include <gtest/gtest.h>

#include <fstream>

namespace vp::test
{

TEST(FrameNames, DigitsAsAskedFor)
{
	const TemporaryFolder folder;
	EXPECT_EQ(write::FrameNames::create("{frame}.png")->of(12), "12.png");
	EXPECT_EQ(write::FrameNames::create("a{frame:04}b.png")->of(7), "a0007b.png");
	EXPECT_EQ(write::FrameNames::create("{frame:2}.png")->of(12345), "12345.png");
	EXPECT_EQ(write::FrameNames::create(folder / "x-{frame:3}.png")->of(0), folder / "x-000.png");
}

TEST(FrameNames, PatternsThatNameNoFrames)
{
	for (const char* pattern : {"a.png", "{}.png", "{frame", "{frame:}.png", "{frame:x}.png", "{frame:4d}.png",
	                            "{frame:-4}.png", "{frame:0}.png", "{frame:21}.png", "{frames}.png"})
	{
		const Result<write::FrameNames> names = write::FrameNames::create(pattern);
		ASSERT_FALSE(names) << pattern;
		EXPECT_EQ(names.error().kind, ErrorKind::usage) << pattern;
		EXPECT_NE(names.error().message.find(pattern), std::string::npos) << names.error().message;
	}
}

TEST(FrameNames, OfOtherThings)
{
	EXPECT_EQ(write::FrameNames::create("a{sheet}.png", "{sheet}")->of(3), "a3.png");
	EXPECT_EQ(write::FrameNames::create("a{sheet:02}.png", "{sheet}")->of(3), "a03.png");
	const Result<write::FrameNames> names = write::FrameNames::create("a{frame}.png", "{sheet}");
	ASSERT_FALSE(names);
	EXPECT_NE(names.error().message.find("sheets need names of their own; put {sheet} into it"), std::string::npos)
	    << names.error().message;
}

TEST(FrameNames, AFileIsNoFolder)
{
	const TemporaryFolder folder;
	EXPECT_TRUE(write::FrameNames::create(folder / "none/{frame}.png"));
	std::ofstream(folder / "none") << "a file";
	const Result<write::FrameNames> names = write::FrameNames::create(folder / "none/{frame}.png");
	ASSERT_FALSE(names);
	EXPECT_EQ(names.error().kind, ErrorKind::output);
	EXPECT_NE(names.error().message.find("none is no folder"), std::string::npos) << names.error().message;
}

} // namespace vp::test
