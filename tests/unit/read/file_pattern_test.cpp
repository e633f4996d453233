#include "base/file_pattern.h"

#include "sample_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace vp::read
{

TEST(FilePattern, NumbersAreComparedAsNumbers)
{
	EXPECT_TRUE(comesBefore("s2.tif", "s10.tif"));
	EXPECT_TRUE(comesBefore("s02.tif", "s10.tif"));
	EXPECT_FALSE(comesBefore("s10.tif", "s9.tif"));
	EXPECT_TRUE(comesBefore("a1b2", "a1b10"));
	EXPECT_TRUE(comesBefore("a", "a1"));
	EXPECT_FALSE(comesBefore("b1", "a2"));
	EXPECT_FALSE(comesBefore("a1", "a1"));
	EXPECT_NE(comesBefore("a1", "a01"), comesBefore("a01", "a1")); // one order of names that are alike
}

TEST(FilePattern, ListsWhatItMatches)
{
	const TemporaryFolder folder;
	for (const char* name : {"s10.tif", "s2.tif", "s2.png", ".s1.tif"})
		std::ofstream(folder / name) << "x";
	std::filesystem::create_directory(folder / "s3.tif");
	const std::string pattern = folder / "s*.tif";
	EXPECT_TRUE(isFilePattern(pattern));
	EXPECT_EQ(filesOfPattern(pattern), (std::vector<std::string>{folder / "s2.tif", folder / "s10.tif"}));
	EXPECT_EQ(filesOfPattern(folder / "").size(), 3u);
	EXPECT_FALSE(isFilePattern(folder / "s2.tif"));
	std::ofstream(folder / "a[1].tif") << "x";
	EXPECT_FALSE(isFilePattern(folder / "a[1].tif")); // a file of that name
}

} // namespace vp::read
