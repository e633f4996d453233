#include "report/duration.h"

#include <gtest/gtest.h>

namespace vp::test
{

TEST(Duration, ReadsAsAPersonWouldWriteIt)
{
	using app::durationText;
	EXPECT_EQ(durationText(0.0), "0 s");
	EXPECT_EQ(durationText(0.00234), "2.34 µs");
	EXPECT_EQ(durationText(0.8915), "892 µs");
	EXPECT_EQ(durationText(0.9996), "1.00 ms");
	EXPECT_EQ(durationText(8.912), "8.91 ms");
	EXPECT_EQ(durationText(99.96), "100 ms");
	EXPECT_EQ(durationText(999.7), "1.00 s");
	EXPECT_EQ(durationText(1290.0), "1.29 s");
	EXPECT_EQ(durationText(59'400.0), "59.4 s");
	EXPECT_EQ(durationText(59'960.0), "1 min 0 s");
	EXPECT_EQ(durationText(125'400.0), "2 min 5 s");
}

} // namespace vp::test
