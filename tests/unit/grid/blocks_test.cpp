#include "grid/measure.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace vp::grid
{
namespace
{

TEST(Blocks, AllTestGridsAreValid)
{
	for (const Block& block : test::allGrids())
		EXPECT_NO_THROW(validate(block)) << block.name;
}

TEST(Blocks, TestFieldsFollowTheirPoints)
{
	for (const Block& block : test::allGrids())
		std::visit(
		    [&](const auto& grid)
		    {
			    const Field& linear = block.fields[block.fields.size() - 2];
			    const Field& id = block.fields.back();
			    ASSERT_EQ(linear.name, "linear");
			    ASSERT_EQ(id.name, "id");
			    for (PointId p = 0; p < grid.pointCount(); ++p)
				    EXPECT_EQ(linear.value(grid.sourcePoint(p), 0), test::linearAt(grid.point(p)));
			    for (CellId c = 0; c < grid.cellCount(); ++c)
				    EXPECT_EQ(id.value(grid.sourceCell(c), 0), double(grid.sourceCell(c)));
		    },
		    block.grid);
}

TEST(Blocks, ValidateSeesWhatIsBroken)
{
	const auto broken = [](const char* name, auto&& harm)
	{
		Block block = test::gridNamed(name);
		harm(block);
		EXPECT_THROW(validate(block), std::logic_error) << name;
	};
	for (const char* name : {"blob", "shell", "hexes", "tets", "mixed_polyhedra"})
	{
		broken(name, [](Block& b) { b.boundary.faces.back() = b.boundary.faces.front(); });
		broken(name, [](Block& b) { b.boundary.faces.pop_back(); });
		broken(name, [](Block& b) { b.boundary.patches[0].box.hi = b.boundary.patches[0].box.lo; });
		broken(name, [](Block& b) { b.boundary.groups[0].box.lo += 0.1; });
		broken(name, [](Block& b) { b.boundary.groups.pop_back(); });
		broken(name, [](Block& b) { b.bounds.hi -= 0.1; });
		broken(name, [](Block& b) { b.vantage.push_back(kNoCell); });
		broken(name, [](Block& b) { b.inverted = {3, 2}; });
		broken(name, [](Block& b) { b.fields[0] = makeField<float>("few", Association::point, 1, {1, 2, 3}); });
		broken(name, [](Block& b) { b.fields.push_back(makeField<float>("few", Association::cell, 1, {1})); });
	}
	// The grid gives no way to harm its records; this is what a stray write would do.
	broken("hexes",
	       [](Block& b) { const_cast<std::uint32_t&>(std::get<UnstructuredGrid>(b.grid).records()[5]) = 1000000; });
}

TEST(Blocks, Bounds)
{
	EXPECT_EQ(test::gridNamed("blob").bounds.lo, Vec3(-3.0));
	EXPECT_EQ(test::gridNamed("blob").bounds.hi, Vec3(3.0));
	// The far point of no cell is not in them.
	EXPECT_LT(test::gridNamed("mixed_polyhedra").bounds.hi.x, 5.0);
}

TEST(Blocks, SoundGridsHaveNoInvertedCells)
{
	for (const char* name : {"blob", "graded", "shell", "hexes", "tets", "mixed", "left_handed", "collapsed_axis",
	                         "collapsed_hexahedra", "hexagonal_prisms", "mixed_polyhedra", "two_to_one", "u_shape"})
		EXPECT_TRUE(test::gridNamed(name).inverted.empty()) << name;
}

// Some cells list their points the other way round. They lie where they would lie otherwise: nothing is folded.
TEST(Blocks, CellsNumberedTheOtherWayAreNoFolds)
{
	const Block& block = test::gridNamed("inverted");
	const auto& grid = std::get<UnstructuredGrid>(block.grid);
	EXPECT_TRUE(block.inverted.empty());
	CellFaces faces;
	std::size_t negative = 0;
	for (CellId c = 0; c < grid.cellCount(); ++c)
		negative += signedVolume(grid, c, faces) < 0.0;
	EXPECT_GT(negative, 5u);
}

TEST(Blocks, VantagePointsSpread)
{
	const Block& lattice = test::gridNamed("blob");
	EXPECT_EQ(lattice.vantage.size(), 6u);
	const Block& hexes = test::gridNamed("hexes");
	EXPECT_GE(hexes.vantage.size(), 14u);
	EXPECT_LE(hexes.vantage.size(), 17u);
	// In both pieces.
	const Block& pieces = test::gridNamed("two_pieces");
	const auto& grid = std::get<UnstructuredGrid>(pieces.grid);
	int left = 0;
	for (const CellId c : pieces.vantage)
		left += cellCenter(grid, c).x < 0.5;
	EXPECT_GT(left, 0);
	EXPECT_LT(left, static_cast<int>(pieces.vantage.size()));
}

TEST(Blocks, CoordinatesThatAreNoNumbers)
{
	const double inf = std::numeric_limits<double>::infinity();
	for (const double odd : {std::nan(""), inf, -inf, 1e308, -1e308})
	{
		test::CellListMaker maker;
		for (const Vec3& p :
		     {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(odd, 1, 1), Vec3(1, odd, odd)})
			maker.point(p);
		maker.cell(10, {0, 1, 2, 3});
		maker.cell(10, {4, 1, 2, 3});
		maker.cell(10, {4, 1, 2, 5});
		maker.cell(13, {4, 1, 2, 5, 0, 3});
		maker.polyhedron({{4, 1, 2}, {4, 1, 5}, {4, 2, 5}, {1, 2, 5}});
		const Block block = maker.block("odd");
		EXPECT_NO_THROW(validate(block)) << odd;
		EXPECT_TRUE(std::isfinite(block.bounds.diagonal()) || std::abs(odd) == 1e308);
	}
}

TEST(Blocks, SetsSumUp)
{
	BlockSet set;
	EXPECT_EQ(set.cellCount(), 0u);
	EXPECT_TRUE(set.bounds().empty());
	set.blocks.push_back(test::gridNamed("blob"));
	EXPECT_STREQ(set.kind(), "image");
	set.blocks.push_back(test::gridNamed("left_handed"));
	EXPECT_STREQ(set.kind(), "block-structured");
	EXPECT_EQ(set.cellCount(), 512u + 4 * 5 * 6);
	EXPECT_EQ(set.pointCount(), 729u + 5 * 6 * 7);
	EXPECT_EQ(set.bounds().hi, Vec3(3.0, 3.0, 3.0));
	set.blocks.push_back(test::gridNamed("hexes"));
	EXPECT_STREQ(set.kind(), "hybrid");
	set.blocks = {test::gridNamed("hexes"), test::gridNamed("tets")};
	EXPECT_STREQ(set.kind(), "unstructured");
}

TEST(Blocks, LatticesWithoutCells)
{
	for (const std::array<std::uint32_t, 3>& points :
	     std::vector<std::array<std::uint32_t, 3>>{{1, 5, 5}, {5, 5, 1}, {0, 0, 0}, {1, 1, 1}})
	{
		Block block;
		block.grid = UniformGrid(points, Vec3(0.0), Vec3(1.0));
		finishBlock(block);
		EXPECT_EQ(std::get<UniformGrid>(block.grid).cellCount(), 0u);
		EXPECT_NO_THROW(validate(block));
	}
}

} // namespace
} // namespace vp::grid
