#include "read/series.h"

#include <gtest/gtest.h>

namespace vp::test
{

using read::FileSeries;
using read::numbersOfNames;
using read::parseSeries;

TEST(Series, NumbersOfNames)
{
	EXPECT_EQ(numbersOfNames({"a_02.vti", "a_03.vti", "a_10.vti"}), (std::optional<std::vector<double>>{{2, 3, 10}}));
	EXPECT_EQ(numbersOfNames({"a9.vti", "a10.vti"}), (std::optional<std::vector<double>>{{9, 10}}));
	EXPECT_EQ(numbersOfNames({"d/run3/x_1.vti", "d/run3/x_21.vti"}), (std::optional<std::vector<double>>{{1, 21}}));
	EXPECT_EQ(numbersOfNames({"3", "12"}), (std::optional<std::vector<double>>{{3, 12}}));
	for (const std::vector<std::string>& others : {std::vector<std::string>{"a_1.vti"},
	                                               {"a_1.vti", "b_1.vti"},
	                                               {"a_1.vti", "a_2.vtu"},
	                                               {"a_1.vti", "a_01.vti"},
	                                               {"a_1_1.vti", "a_2_2.vti"},
	                                               {"a.vti", "a_1.vti"},
	                                               {"a_x.vti", "a_y.vti"},
	                                               {"a_1.vti", "a_1.vti"}})
		EXPECT_FALSE(numbersOfNames(others)) << others.front();
}

TEST(Series, IsOneInput)
{
	const FileSeries series{{"a 1.vti", "b:\n2.vti"}, {-0.1, 1e300}};
	const std::optional<FileSeries> read = parseSeries(read::seriesInput(series));
	ASSERT_TRUE(read);
	EXPECT_EQ(read->files, series.files);
	EXPECT_EQ(read->times, series.times);
	for (const char* other : {"", "a.vti", "series:", "series:a.vti", "demo:shell"})
		EXPECT_FALSE(parseSeries(other)) << other;
}

TEST(Series, StackIsOneInput)
{
	const std::vector<std::string> files{"a 1.tif", "b:\n2.tif", "stack:3.tif"};
	EXPECT_EQ(read::parseStack(read::stackInput(files)), files);
	EXPECT_FALSE(parseSeries(read::stackInput(files)));
	for (const char* other : {"", "a.vti", "stack:", "stack:a.vti", "demo:shell"})
		EXPECT_TRUE(read::parseStack(other).empty()) << other;
}

} // namespace vp::test
