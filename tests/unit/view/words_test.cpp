#include "view/words.h"

#include "view/settings.h"

#include <gtest/gtest.h>

namespace vp::view::test
{

TEST(Words, Directions)
{
	EXPECT_EQ(*parseDirection("y"), Vec3(0.0, 1.0, 0.0));
	EXPECT_EQ(*parseDirection("-y"), Vec3(0.0, -1.0, 0.0));
	EXPECT_EQ(*parseDirection("-1 0 2"), Vec3(-1.0, 0.0, 2.0));
	for (const char* none : {"", "-", "w", "--x", "xy", "1 2", "1 2 3 4", "0 0 0"})
		EXPECT_FALSE(parseDirection(none)) << none;
}

TEST(Words, WindowAndLevel)
{
	ViewSpec spec;
	ASSERT_TRUE(setByKey(spec, "window_level", "400 40"));
	EXPECT_EQ(spec.look.range, (std::pair{-160.0, 240.0}));
	EXPECT_FALSE(setByKey(spec, "window_level", "400"));
}

} // namespace vp::view::test
