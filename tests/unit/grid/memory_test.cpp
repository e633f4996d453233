#include "grid/check/memory.h"

#include "grid/demo/demo.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

constexpr std::size_t kN = 6;
constexpr std::size_t kPoints = (kN + 1) * (kN + 1) * (kN + 1);
constexpr std::size_t kCells = kN * kN * kN;
constexpr std::size_t kArrays = kPoints * 4 * 4; // s and v, floats

grid::Memory memoryOf(const std::string& demo)
{
	return grid::memoryOf(*grid::parseDemo(demo + ":6"));
}

} // namespace

TEST(Memory, OfStructuredGridsIsTheirPointsAndArrays)
{
	EXPECT_EQ(memoryOf("shell").geometry, kPoints * 3 * 4);
	EXPECT_EQ(memoryOf("graded").geometry, 3 * (kN + 1) * 8);
	EXPECT_EQ(memoryOf("blob").geometry, 0u);
	for (const char* demo : {"shell", "graded", "blob"})
	{
		const grid::Memory memory = memoryOf(demo);
		EXPECT_EQ(memory.arrays, kArrays) << demo;
		EXPECT_EQ(memory.adjacency, 0u) << demo;
		// At the least each face of the boundary once, of eight bytes; far less than the arrays of a large grid.
		EXPECT_GE(memory.boundary, 6 * kN * kN * 8) << demo;
		EXPECT_EQ(memory.read() + memory.built(),
		          memory.geometry + memory.arrays + memory.boundary + memory.folds + memory.trees + memory.seams);
	}
}

TEST(Memory, OfUnstructuredGridsCountsNeighbors)
{
	const grid::Memory hexes = memoryOf("hexes");
	EXPECT_EQ(hexes.geometry, kPoints * 3 * 4 + kCells * 8 * 4);
	EXPECT_GE(hexes.adjacency, kCells * 6 * 4);
	const grid::Memory tets = memoryOf("tets");
	EXPECT_EQ(tets.geometry, kPoints * 3 * 4 + 5 * kCells * 4 * 4);
	EXPECT_GE(tets.adjacency, 5 * kCells * 4 * 4);
}

TEST(Memory, ATreeCountsOnceItIsBuilt)
{
	const grid::BlockSet set = *grid::parseDemo("shell:20");
	EXPECT_EQ(grid::memoryOf(set).trees, 0u);
	const grid::BlockTree& tree = grid::treeOf(set.blocks[0]);
	EXPECT_EQ(grid::memoryOf(set).trees, tree.bytes());
	EXPECT_GT(tree.bytes(), 0u);
}

TEST(Memory, ASetIsTheSumOfItsBlocks)
{
	grid::BlockSet set = *grid::parseDemo("shell:6");
	set.blocks.push_back(grid::parseDemo("hexes:6")->blocks[0]);
	EXPECT_EQ(grid::memoryOf(set).read(), memoryOf("shell").read() + memoryOf("hexes").read());
	EXPECT_EQ(grid::memoryOf(set).seams, 0u); // not looked for
	grid::matchInterfaces(set);
	EXPECT_GT(grid::memoryOf(set).seams, 0u);
}

} // namespace vp::test
