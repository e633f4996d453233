#include "baseline.h"

#include "write/png.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>

namespace vp::render::test
{

namespace
{

// A folder of its own, gone at the end.
class Png : public testing::Test
{
protected:
	Png()
	{
		const auto* test = testing::UnitTest::GetInstance()->current_test_info();
		folder_ = std::filesystem::temp_directory_path() /
		          ("vprobe_png_" + std::string(test->name()) + std::to_string(getpid()));
		std::filesystem::create_directories(folder_);
	}
	~Png() override { std::filesystem::remove_all(folder_); }

	std::string in(const char* name) const { return (folder_ / name).string(); }
	std::size_t files() const
	{
		return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
	}

private:
	std::filesystem::path folder_;
};

Picture gradient(std::uint8_t alpha)
{
	Picture picture{17, 9, {}};
	for (std::uint32_t y = 0; y < picture.height; ++y)
		for (std::uint32_t x = 0; x < picture.width; ++x)
			picture.rgba.insert(picture.rgba.end(),
			                    {static_cast<std::uint8_t>(15 * x), static_cast<std::uint8_t>(28 * y), 77, alpha});
	return picture;
}

} // namespace

TEST_F(Png, KeepsEveryPixel)
{
	for (const std::uint8_t alpha : {std::uint8_t(255), std::uint8_t(100)})
	{
		const Picture picture = gradient(alpha);
		const auto written = write::writePng(picture, in("a.png"));
		ASSERT_TRUE(written);
		const Picture back = readPng(in("a.png"));
		EXPECT_EQ(back.width, picture.width);
		EXPECT_EQ(back.rgba, picture.rgba);
	}
	EXPECT_EQ(files(), 1u);
}

TEST_F(Png, AFailureNamesTheFileAndLeavesNothing)
{
	const auto nowhere = write::writePng(gradient(255), "/dev/null/picture.png");
	ASSERT_FALSE(nowhere);
	EXPECT_EQ(nowhere.error().kind, ErrorKind::output);
	EXPECT_NE(nowhere.error().message.find("/dev/null/picture.png"), std::string::npos);

	// A folder is in the way: written beside it, but not put in its place.
	std::filesystem::create_directories(in("taken.png/inside"));
	const auto taken = write::writePng(gradient(255), in("taken.png"));
	ASSERT_FALSE(taken);
	EXPECT_NE(taken.error().message.find("taken.png"), std::string::npos);
	EXPECT_EQ(files(), 1u);
}

TEST_F(Png, AFailureKeepsWhatWasThere)
{
	ASSERT_TRUE(write::writePng(gradient(255), in("a.png")));
	std::filesystem::permissions(in("a.png"), std::filesystem::perms::owner_read);
	EXPECT_FALSE(write::writePng(gradient(255), "/dev/full/a.png"));
	EXPECT_EQ(readPng(in("a.png")).rgba, gradient(255).rgba);
}

} // namespace vp::render::test
