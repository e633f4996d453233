#include "vectors/vector_array.h"

#include <gtest/gtest.h>

namespace vp::vectors::test
{

namespace
{

// A block with arrays of three components, of these names and units, and one number beside them.
grid::BlockSet setWith(const std::vector<std::pair<std::string, std::string>>& arrays)
{
	grid::BlockSet set;
	grid::Block& block = set.blocks.emplace_back();
	block.grid = grid::UniformGrid({2, 2, 2}, Vec3(0.0), Vec3(1.0));
	block.fields.push_back(grid::makeField("U", grid::Association::cell, 1, std::vector<float>(1)));
	for (const auto& [name, units] : arrays)
	{
		block.fields.push_back(grid::makeField(name, grid::Association::point, 3, std::vector<float>(24)));
		block.fields.back().units = units;
	}
	return set;
}

std::string chosen(const std::vector<std::pair<std::string, std::string>>& arrays)
{
	return chooseVectors(setWith(arrays), "")->name;
}

} // namespace

TEST(VectorArray, AVelocityComesFirst)
{
	EXPECT_EQ(chosen({{"normals", ""}, {"force", "N"}}), "normals");
	EXPECT_EQ(chosen({{"normals", ""}, {"flow", "m/s"}, {"force", "N"}}), "flow");
	EXPECT_EQ(chosen({{"normals", ""}, {"flow", "m/s"}, {"U", ""}}), "U");
	EXPECT_EQ(chosen({{"v", ""}, {"Velocity", ""}}), "Velocity");
	EXPECT_FALSE(chooseVectors(setWith({}), ""));
	EXPECT_EQ(chooseVectors(setWith({{"normals", ""}, {"U", ""}}), "normals")->name, "normals");
}

} // namespace vp::vectors::test
