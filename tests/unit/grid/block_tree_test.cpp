#include "exhaustive.h"
#include "test_grids.h"

#include "grid/demo/demo.h"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>

namespace vp::test
{

namespace
{

// The cells of the leaves for which meets(box) holds, in the order of the visit.
template <class Meets>
std::vector<CellId> cellsWhere(const grid::BlockTree& tree, Meets&& meets)
{
	std::vector<CellId> cells;
	tree.visitWhere(meets, [&](CellId cell) { cells.push_back(cell); });
	return cells;
}

bool holdsCell(const Box& box, const grid::Block& block, CellId cell)
{
	return std::ranges::all_of(
	    cellCorners(block, cell), [&](const Vec3& p)
	    { return glm::all(glm::greaterThanEqual(p, box.lo)) && glm::all(glm::lessThanEqual(p, box.hi)); });
}

grid::Block demo(const char* name, int n)
{
	return std::move(grid::makeDemo(name, n)->blocks[0]);
}

} // namespace

TEST(BlockTree, HoldsEveryCellOnce)
{
	std::vector<grid::Block> blocks = allGrids();
	blocks.push_back(demo("shell", 37)); // several groups, sides that no cube fills
	blocks.push_back(demo("tets", 20));
	for (const grid::Block& block : blocks)
	{
		std::vector<CellId> all(cellCount(block));
		std::iota(all.begin(), all.end(), 0u);
		EXPECT_EQ(sorted(cellsWhere(grid::treeOf(block), [](const Box&) { return true; })), all) << block.name;
		EXPECT_TRUE(cellsWhere(grid::treeOf(block), [](const Box&) { return false; }).empty()) << block.name;
	}
}

TEST(BlockTree, BoxesHoldTheirCells)
{
	for (const grid::Block& block : {demo("shell", 20), demo("hexes", 18), gridNamed("mixed_polyhedra")})
	{
		const grid::BlockTree& tree = grid::treeOf(block);
		for (const grid::BlockTree::Node& group : tree.groups())
			for (std::uint32_t leaf = group.begin; leaf < group.end; ++leaf)
			{
				const Box& box = tree.leaves()[leaf].box;
				EXPECT_TRUE(glm::all(glm::lessThanEqual(group.box.lo, box.lo)) &&
				            glm::all(glm::greaterThanEqual(group.box.hi, box.hi)));
				tree.forEachCell(tree.leaves()[leaf], [&](CellId cell) { EXPECT_TRUE(holdsCell(box, block, cell)); });
			}
	}
}

TEST(BlockTree, OverAList)
{
	const grid::Block block = demo("shell", 30);
	std::vector<CellId> list;
	for (CellId c = 5; c < cellCount(block); c += 7)
		list.push_back(c);
	const grid::BlockTree tree(std::get<grid::CurvilinearGrid>(block.grid), list);
	EXPECT_EQ(cellsWhere(tree, [](const Box&) { return true; }), list);
	EXPECT_GT(tree.leaves().size(), 5u);
	EXPECT_TRUE(cellsWhere(grid::BlockTree(), [](const Box&) { return true; }).empty());
}

TEST(BlockTree, AsksFewBoxesAndTakesLittleMemory)
{
	const grid::Block block = demo("shell", 96);
	const grid::BlockTree& tree = grid::treeOf(block);
	const Side side({block.bounds.center(), {0.3, 0.5, 0.81}});
	const auto meets = [&](const Box& box)
	{ return std::abs(side.distance(box.center())) <= glm::dot(glm::abs(side.normal()), 0.5 * box.size()); };
	std::size_t cells = 0;
	const std::size_t boxes = tree.visitWhere(meets, [&](CellId) { ++cells; });
	EXPECT_LT(cells, cellCount(block) / 4);
	EXPECT_LT(boxes, tree.leaves().size());
	EXPECT_LT(tree.bytes(), cellCount(block) / 4);
}

TEST(BlockTree, ThreadsThatAskAtOnceGetOne)
{
	const grid::Block block = demo("hexes", 20);
	const grid::Block copy = block;
	std::vector<const grid::BlockTree*> trees(4);
	std::vector<std::thread> threads;
	for (std::size_t t = 0; t < trees.size(); ++t)
		threads.emplace_back([&, t] { trees[t] = &grid::treeOf(t % 2 ? copy : block); });
	for (std::thread& thread : threads)
		thread.join();
	for (const grid::BlockTree* tree : trees)
		EXPECT_EQ(tree, trees[0]);
	EXPECT_FALSE(trees[0]->leaves().empty());
}

} // namespace vp::test
