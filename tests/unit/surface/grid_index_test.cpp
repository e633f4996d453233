#include "surface/grid_index.h"

#include <gtest/gtest.h>

namespace vp::surface
{

TEST(GridIndex, IsReadAsItIsWritten)
{
	for (const GridIndex& at : {GridIndex{0, 12.5}, GridIndex{1, 0.0}, GridIndex{2, 1.0 / 3.0}, GridIndex{0, -1.0}})
	{
		const Result<GridIndexRange> read = parseGridIndex(nameOf(at));
		ASSERT_TRUE(read) << nameOf(at);
		EXPECT_TRUE(read->isOne());
		EXPECT_EQ(read->at(0.0), at);
	}
	EXPECT_EQ(nameOf({0, 12.5}), "i=12.5");
	EXPECT_EQ(nameOf({2, 3.0}), "k=3");
}

TEST(GridIndex, ARangeHasBothItsEnds)
{
	const Result<GridIndexRange> range = parseGridIndex("j=0.1..30.7");
	ASSERT_TRUE(range);
	EXPECT_EQ(*range, (GridIndexRange{1, 0.1, 30.7}));
	EXPECT_EQ(range->at(0.0).index, 0.1);
	EXPECT_EQ(range->at(1.0).index, 30.7); // 0.1 + (30.7 - 0.1) is another number
	EXPECT_NEAR(range->at(0.5).index, 15.4, 1e-14);
	EXPECT_EQ(parseGridIndex("i=5..2")->at(1.0).index, 2.0);
}

TEST(GridIndex, AnythingElseIsToldWhatBelongsThere)
{
	for (const char* text : {"", "i", "i=", "l=3", "x=3", "=3", "i=x", "i=3x", "i=nan", "i=inf", "i=1e999", "i=..",
	                         "i=1..", "i=..2", "i=1..2..3", "i= 3", "sphere:2", "x*y", "I=3"})
	{
		const Result<GridIndexRange> read = parseGridIndex(text);
		ASSERT_FALSE(read) << text;
		EXPECT_EQ(read.error().kind, ErrorKind::usage);
		EXPECT_NE(read.error().message.find("12.5"), std::string::npos) << text;
	}
}

TEST(GridIndex, LiesInALayerOrBetweenTwo)
{
	constexpr std::uint32_t cells = 5;
	EXPECT_EQ(layersOf(0.0, cells).cell, 0u);
	EXPECT_FALSE(layersOf(0.0, cells).has_other_side);
	EXPECT_EQ(layersOf(5.0, cells).cell, 4u);
	EXPECT_FALSE(layersOf(5.0, cells).has_other_side);
	for (std::uint32_t point = 1; point < cells; ++point)
	{
		const GridLayers between = layersOf(point, cells);
		EXPECT_EQ(between.cell, point - 1);
		EXPECT_TRUE(between.has_other_side);
		EXPECT_EQ(placeIn(between.cell, point), 1.0);
		EXPECT_EQ(placeIn(between.cell + 1, point), 0.0);
	}
	for (const double fraction : {1e-300, 0.25, 1.0 - 1e-15})
	{
		const GridLayers within = layersOf(2.0 * (fraction > 1e-3) + fraction, cells);
		EXPECT_EQ(within.cell, fraction > 1e-3 ? 2u : 0u);
		EXPECT_FALSE(within.has_other_side);
	}
	EXPECT_EQ(placeIn(2, 2.25), 0.25);
}

} // namespace vp::surface
