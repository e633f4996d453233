#include "hyper_tree_samples.h"
#include "read/read.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vp;

TEST(HyperTreeGrid, GivesItsLeavesWithoutGaps)
{
	const TemporaryFolder folder;
	const std::string path = folder / "trees.htg";
	const std::size_t leaves = writeTrees(path);
	EXPECT_GT(leaves, 24u);

	auto set = read::readInputs({path}, {}, nullptr);
	ASSERT_TRUE(set) << set.error().message;
	EXPECT_EQ(set->cellCount(), leaves);
	const grid::Block& block = set->blocks.at(0);
	EXPECT_NO_THROW(grid::validate(block));
	const auto& grid = std::get<grid::UnstructuredGrid>(block.grid);
	ASSERT_EQ(block.fields.size(), 1u);
	double volume = 0.0;
	for (CellId c = 0; c < grid.cellCount(); ++c)
	{
		Box box;
		const grid::CellPoints points = grid.cellPoints(c);
		for (int v = 0; v < points.size; ++v)
			box.include(grid.point(points.id[v]));
		const double side = std::pow(0.5, block.fields[0].value(grid.sourceCell(c), 0)); // the array is the depth
		for (int axis = 0; axis < 3; ++axis)
			EXPECT_DOUBLE_EQ(box.size()[axis], side);
		volume += side * side * side;
	}
	EXPECT_DOUBLE_EQ(volume, 24.0);
}
