#include "grid/field_choice.h"

#include <gtest/gtest.h>

#include <cmath>
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
	expectError("both", "0", ErrorKind::usage, "leave it out");
	expectError("v", "xy", ErrorKind::usage, "use x, y, z, or magnitude");
}

TEST(FieldChoice, ComponentsHaveWords)
{
	EXPECT_EQ(grid::componentText(*grid::parseComponent("zy")), "zy");
	for (const int component : {grid::kMagnitude, 0, 1, 2, 3, 12})
		EXPECT_EQ(grid::parseComponent(grid::componentText(component)), component);
	EXPECT_EQ(grid::parseComponent("2"), 2);
	for (const char* word : {"", "-1", "w", "1x", "99999999999"})
		EXPECT_FALSE(grid::parseComponent(word)) << word;
}

// Six different numbers: each has its name, and the magnitude is that of the whole matrix, sqrt(1 + 4 + 9 + 2 (16 + 25
// + 36)).
TEST(FieldChoice, TensorsHaveRowsAndColumns)
{
	grid::BlockSet set;
	std::vector<double> six, nine;
	for (int point = 0; point < 8; ++point)
		for (int c = 1; c <= 9; ++c)
		{
			if (c <= 6)
				six.push_back(c); // xx 1, yy 2, zz 3, xy 4, yz 5, xz 6
			nine.push_back(c);
		}
	set.blocks.push_back(blockWith(
	    {grid::makeField("six", Association::point, 6, six), grid::makeField("nine", Association::point, 9, nine)}));
	const auto chosen = [&](const char* array, const char* component)
	{ return *grid::chooseField(set, array, grid::parseComponent(component)).value(); };
	const auto shown = [&](const char* array, const char* component)
	{
		const grid::FieldChoice choice = chosen(array, component);
		return grid::fieldRange(set, choice).first;
	};
	const char* const names[] = {"xx", "yy", "zz", "xy", "yz", "xz"};
	for (int c = 0; c < 6; ++c)
	{
		EXPECT_EQ(shown("six", names[c]), c + 1.0) << names[c];
		EXPECT_EQ(chosen("six", names[c]).title(set), std::string("six ") + names[c]);
	}
	EXPECT_EQ(shown("six", "yx"), 4.0); // it is symmetric
	EXPECT_EQ(shown("six", "zy"), 5.0);
	EXPECT_EQ(shown("nine", "xy"), 2.0);
	EXPECT_EQ(shown("nine", "yx"), 4.0);
	EXPECT_EQ(shown("nine", "zz"), 9.0);
	EXPECT_DOUBLE_EQ(shown("six", "magnitude"), std::sqrt(1.0 + 4.0 + 9.0 + 2.0 * (16.0 + 25.0 + 36.0)));
	EXPECT_DOUBLE_EQ(shown("nine", "magnitude"), std::sqrt(285.0));
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
