#include "grid/field_choice.h"

#include <gtest/gtest.h>

#include <limits>

namespace vp::test
{

namespace
{

using grid::Association;

grid::Block blockWith(std::vector<grid::Field> fields)
{
	grid::Block block;
	block.grid = grid::UniformGrid({2, 2, 2}, Vec3(0.0), Vec3(1.0));
	block.fields = std::move(fields);
	return block;
}

// Block 0 lacks what block 1 has, and the other way round.
grid::BlockSet sample()
{
	grid::BlockSet set;
	set.blocks.push_back(blockWith({grid::makeField("both", Association::cell, 1, std::vector<int>{7})}));
	set.blocks.push_back(
	    blockWith({grid::makeField("v", Association::point, 3, std::vector<float>(24, 2.0f)),
	               grid::makeField("both", Association::point, 1, std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}),
	               grid::makeField("cell:odd", Association::point, 4, std::vector<float>(32, 1.0f))}));
	return set;
}

void expectError(const std::string& array, const std::string& component, ErrorKind kind, const std::string& word)
{
	const auto chosen = grid::chooseField(sample(), array, grid::parseComponent(component));
	ASSERT_FALSE(chosen) << array << ' ' << component;
	EXPECT_EQ(chosen.error().kind, kind);
	EXPECT_NE(chosen.error().message.find(word), std::string::npos) << chosen.error().message;
	EXPECT_EQ(chosen.error().message.find('\n'), std::string::npos);
}

grid::FieldChoice choose(const std::string& array, const std::string& component = "")
{
	return grid::chooseField(sample(), array, grid::parseComponent(component)).value().value();
}

} // namespace

TEST(FieldChoice, TakesTheFirstPointArrayOfAnyBlock)
{
	const grid::FieldChoice choice = choose("");
	EXPECT_EQ(choice.name, "v");
	EXPECT_EQ(choice.association, Association::point);
	EXPECT_EQ(choice.component, grid::kMagnitude);
}

TEST(FieldChoice, TakesACellArrayWhereThereIsNoPointArray)
{
	grid::BlockSet set = sample();
	set.blocks.pop_back();
	EXPECT_EQ(grid::chooseField(set, "").value()->association, Association::cell);
	set.blocks[0].fields.clear();
	EXPECT_FALSE(grid::chooseField(set, "").value().has_value());
	const auto refused = grid::chooseField(set, "", 0);
	ASSERT_FALSE(refused);
	EXPECT_EQ(refused.error().kind, ErrorKind::input);
}

TEST(FieldChoice, NamesMayBePrefixed)
{
	EXPECT_EQ(choose("both").association, Association::point);
	EXPECT_EQ(choose("point:both").association, Association::point);
	EXPECT_EQ(choose("cell:both").association, Association::cell);
	EXPECT_EQ(choose("cell:odd").name, "cell:odd"); // a colon of its own
	EXPECT_EQ(choose("point:cell:odd").name, "cell:odd");
}

TEST(FieldChoice, KnowsItsComponents)
{
	EXPECT_EQ(choose("v", "magnitude").component, grid::kMagnitude);
	EXPECT_EQ(choose("v", "y").component, 1);
	EXPECT_EQ(choose("v", "2").component, 2);
	EXPECT_EQ(choose("both").component, 0);
	EXPECT_EQ(choose("cell:odd", "3").component, 3);
}

TEST(FieldChoice, RefusesWhatCannotBe)
{
	expectError("none", "", ErrorKind::input, "point:both");
	expectError("cell:v", "", ErrorKind::input, "point:v");
	expectError("v", "3", ErrorKind::usage, "`component` 3");
	expectError("both", "y", ErrorKind::usage, "both");
}

TEST(FieldChoice, ComponentsHaveWords)
{
	for (const int component : {grid::kMagnitude, 0, 1, 2, 3, 12})
		EXPECT_EQ(grid::parseComponent(grid::componentText(component)), component);
	EXPECT_EQ(grid::parseComponent("2"), 2);
	for (const char* word : {"", "-1", "w", "1x", "99999999999"})
		EXPECT_FALSE(grid::parseComponent(word)) << word;
}

TEST(FieldChoice, IsFoundInTheBlocksThatHaveIt)
{
	const grid::BlockSet set = sample();
	const grid::FieldChoice choice = choose("v", "y");
	EXPECT_EQ(choice.in(set.blocks[0]), nullptr);
	EXPECT_EQ(choice.in(set.blocks[1]), &set.blocks[1].fields[0]);
	EXPECT_EQ(choice.title(set), "v y");
	EXPECT_EQ(choose("v").title(set), "v magnitude");
	EXPECT_EQ(choose("both").title(set), "both");
	EXPECT_EQ(choose("cell:odd", "3").title(set), "cell:odd 3");
}

TEST(FieldChoice, ItsRangeSpansAllBlocks)
{
	grid::BlockSet set = sample();
	constexpr double nan = std::numeric_limits<double>::quiet_NaN();
	EXPECT_EQ(grid::fieldRange(set, choose("point:both")), std::pair(1.0, 8.0));
	EXPECT_DOUBLE_EQ(grid::fieldRange(set, choose("v")).second, std::sqrt(12.0));
	// A block whose values are all NaN adds nothing.
	set.blocks[0].fields.push_back(grid::makeField("both", Association::point, 1, std::vector<double>(8, nan)));
	EXPECT_EQ(grid::fieldRange(set, choose("point:both")), std::pair(1.0, 8.0));
}

TEST(FieldChoice, ABlockWhoseArrayIsTooNarrowLacksIt)
{
	grid::BlockSet set;
	set.blocks.push_back(blockWith({grid::makeField("v", Association::cell, 3, std::vector<float>{1, 2, 3})}));
	set.blocks.push_back(blockWith({grid::makeField("v", Association::cell, 1, std::vector<float>{9})}));
	const grid::FieldChoice choice = grid::chooseField(set, "v", 2).value().value();
	EXPECT_EQ(choice.in(set.blocks[0]), &set.blocks[0].fields[0]);
	EXPECT_EQ(choice.in(set.blocks[1]), nullptr);
	EXPECT_EQ(grid::fieldRange(set, choice), std::pair(3.0, 3.0));
}

} // namespace vp::test
