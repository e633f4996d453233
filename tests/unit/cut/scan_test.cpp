#include "listed_block.h"
#include "random_window.h"
#include "same_mesh.h"
#include "seamed_sets.h"
#include "sliced_sheet.h"
#include "tries.h"

#include "cut/cutter.h"
#include "measure/components.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

/// The sheet of a request, by a strategy.
SlicedSheet sheetBy(const grid::BlockSet& blocks, cut::CutRequest request, find::Strategy strategy)
{
	request.strategy = strategy;
	cut::Cutter cutter(blocks);
	cut::Cut slice = std::move(cutter.cut(request).value());
	SlicedSheet sheet{&blocks, {}, slice.mesh(blocks, 0)};
	sheet.slice = std::move(slice.sheets[0]);
	return sheet;
}

cut::CutRequest requestOf(const TestPlane& plane)
{
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	return request;
}

/// A set with neighbors, and the same cells as a list, by the same numbers.
struct Pair
{
	grid::BlockSet linked;
	grid::BlockSet listed;

	explicit Pair(grid::BlockSet set) : linked(std::move(set))
	{
		for (const grid::Block& block : linked.blocks)
			listed.blocks.push_back(listedBlock(block));
	}
};

/// Compares what a scan finds in a list, and in a grid with neighbors, with the traversal, to the last bit.
void compare(const Pair& pair, const cut::CutRequest& request)
{
	const SlicedSheet expected = sheetBy(pair.linked, request, find::Strategy::generations);
	for (const grid::BlockSet* blocks : {&pair.listed, &pair.linked})
	{
		const SlicedSheet found = sheetBy(*blocks, request, find::Strategy::scan);
		for (std::size_t b = 0; b < blocks->blocks.size(); ++b)
		{
			EXPECT_EQ(found.cutCells(b), expected.cutCells(b));
			EXPECT_EQ(found.slice.cuts[b].touchedCells(), 0u);
			EXPECT_EQ(found.slice.cuts[b].steps(), 0u);
			EXPECT_EQ(found.slice.cuts[b].scannedCells(),
			          std::get<grid::UnstructuredGrid>(blocks->blocks[b].grid).cellCount());
		}
		expectSameMesh(found.mesh, expected.mesh);
		EXPECT_EQ(measure::countComponents(found.mesh), measure::countComponents(expected.mesh));
	}
}

/// The grids of allGrids() that can be lists: cells of a list are not linked across hanging nodes.
std::vector<const grid::Block*> listableGrids()
{
	std::vector<const grid::Block*> blocks;
	for (const grid::Block& block : allGrids())
		if (const auto* grid = std::get_if<grid::UnstructuredGrid>(&block.grid); grid && !grid->hasLinks())
			blocks.push_back(&block);
	return blocks;
}

std::vector<Pair> seamedPairs()
{
	std::vector<Pair> pairs;
	for (const Place place : {warped, straight})
	{
		pairs.emplace_back(setOfBlocks({hexahedraBlock(place, 0.0, 1.0, true), hexahedraBlock(place, 1.0, 2.0, true)}));
		pairs.emplace_back(setOfBlocks({hexahedraBlock(place, 0.0, 2.0, false)}));
		pairs.emplace_back(
		    setOfBlocks({hexahedraBlock(place, 1.0, 2.0, false), hexahedraBlock(place, 0.0, 1.0, true)}));
	}
	pairs.emplace_back(setOfBlocks({hexahedraBlock(ring, 0.0, 2.0, false)}));
	return pairs;
}

} // namespace

TEST(ScanStrategy, FindsWhatATraversalFinds)
{
	ASSERT_GE(listableGrids().size(), 6u);
	for (const grid::Block* block : listableGrids())
	{
		SCOPED_TRACE(block->name);
		const Pair pair(setOf(*block));
		for (const TestPlane& plane : randomPlanes(block->bounds, tries(30), 71))
			compare(pair, requestOf(plane));
		for (const TestPlane& plane : degeneratePlanes(*block, 72))
			compare(pair, requestOf(plane));
		if (HasFailure())
			return;
	}
}

TEST(ScanStrategy, Windows)
{
	std::mt19937 random(73);
	for (const grid::Block* block : listableGrids())
	{
		SCOPED_TRACE(block->name);
		const Pair pair(setOf(*block));
		for (const TestPlane& plane : randomPlanes(block->bounds, tries(40), 74))
		{
			cut::CutRequest request = requestOf(plane);
			request.probe.sheets[0].window = randomWindow(block->bounds, random);
			const SlicedSheet expected = sheetBy(pair.linked, request, find::Strategy::generations);
			const SlicedSheet found = sheetBy(pair.listed, request, find::Strategy::scan);
			EXPECT_EQ(found.cutCells(), expected.cutCells());
			expectSameMesh(found.mesh, expected.mesh);
		}
		if (HasFailure())
			return;
	}
}

TEST(ScanStrategy, OtherSurfaces)
{
	for (const grid::Block* block : listableGrids())
	{
		SCOPED_TRACE(block->name);
		const Pair pair(setOf(*block));
		const double size = block->bounds.diagonal();
		for (const TestPlane& plane : randomPlanes(block->bounds, tries(4), 75))
			for (const std::string& form :
			     {"sphere:" + std::to_string(0.2 * size), std::string("x*x - y*z + 0.1*x"), std::string("iso:1.25")})
			{
				cut::CutRequest request = requestOf(plane);
				request.probe.sheets[0].form = surface::ImplicitSurface::parse(form).value();
				request.field = grid::chooseField(pair.listed, "linear").value();
				SCOPED_TRACE(form);
				compare(pair, request);
			}
		if (HasFailure())
			return;
	}
}

TEST(ScanStrategy, JoinsWhatMeetsAtSeams)
{
	for (const Pair& pair : seamedPairs())
	{
		SCOPED_TRACE(pair.linked.blocks[0].name);
		EXPECT_TRUE(pair.listed.interfaces.blocks.empty());
		for (const TestPlane& plane : randomPlanes(pair.linked.bounds(), tries(40), 76))
			compare(pair, requestOf(plane));
		// Through points, and through the faces at which blocks meet.
		for (int axis = 0; axis < 3; ++axis)
			for (int step = 0; step <= 2 * kSteps; ++step)
			{
				TestPlane plane{Vec3(0.0), Vec3(0.0)};
				plane.origin[axis] = 0.25 * step;
				plane.normal[axis] = 1.0;
				SCOPED_TRACE(std::to_string(axis) + " " + std::to_string(step));
				compare(pair, requestOf(plane));
			}
		if (HasFailure())
			return;
	}
}

TEST(ScanStrategy, IdsOf32BitsAreThoseOf64)
{
	const grid::Block& block = gridNamed("tets");
	grid::BlockSet narrow = setOf(listedBlock<std::int32_t>(block));
	grid::BlockSet wide = setOf(listedBlock<std::int64_t>(block));
	for (const TestPlane& plane : randomPlanes(block.bounds, 10, 77))
		expectSameMesh(sheetBy(narrow, requestOf(plane), find::Strategy::scan).mesh,
		               sheetBy(wide, requestOf(plane), find::Strategy::scan).mesh);
	EXPECT_LT(std::get<grid::UnstructuredGrid>(narrow.blocks[0].grid).geometryBytes(),
	          std::get<grid::UnstructuredGrid>(wide.blocks[0].grid).geometryBytes());
}

TEST(ScanStrategy, TheSameForAnyNumberOfThreads)
{
	const grid::BlockSet set = setOf(listedBlock(gridNamed("mixed")));
	const cut::CutRequest request = requestOf({set.bounds().center(), {0.3, 0.5, 0.8}});
	const SlicedSheet many = sheetBy(set, request, find::Strategy::scan);
	const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
	const SlicedSheet single = sheetBy(set, request, find::Strategy::scan);
	EXPECT_EQ(many.slice.cuts[0].cells().cells, single.slice.cuts[0].cells().cells);
	EXPECT_EQ(many.mesh.polygon_vertices, single.mesh.polygon_vertices);
}

TEST(ScanStrategy, LeavesOutWhatIsNoCell)
{
	CellListMaker maker;
	for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(9, 9, 9), Vec3(-4, 2, 0)})
		maker.point(p);
	maker.cell(5, {0, 1, 2}); // a triangle
	maker.cell(grid::kTetra, {0, 1, 2, 3});
	maker.cell(0, {});
	grid::BlockSet set;
	grid::Block& block = set.blocks.emplace_back();
	block.grid = grid::UnstructuredGrid::listed(maker.points(), maker.list());
	finishBlock(block);
	const auto& listed = std::get<grid::UnstructuredGrid>(block.grid);
	EXPECT_EQ(listed.cellCount(), 1u);
	EXPECT_EQ(listed.leftOut(), 2u);
	// Points of no cell do not count, wherever they lie.
	EXPECT_EQ(block.bounds.lo, Vec3(0.0));
	EXPECT_EQ(block.bounds.hi, Vec3(1.0));
	const SlicedSheet found = sheetBy(set, requestOf({Vec3(0.2), Vec3(0, 0, 1)}), find::Strategy::scan);
	EXPECT_EQ(found.cutCells(), std::vector<CellId>{1});
	EXPECT_EQ(found.slice.cuts[0].scannedCells(), 1u);
}

TEST(ScanStrategy, AVoxelIsAHexahedron)
{
	CellListMaker maker;
	for (int p = 0; p < 8; ++p)
		maker.point({p & 1, p >> 1 & 1, p >> 2});
	maker.cell(grid::kVoxel, {0, 1, 2, 3, 4, 5, 6, 7});
	grid::BlockSet set;
	set.blocks.emplace_back().grid = grid::UnstructuredGrid::listed(maker.points(), maker.list());
	finishBlock(set.blocks[0]);
	const SlicedSheet found = sheetBy(set, requestOf({Vec3(0.5), Vec3(0, 0, 1)}), find::Strategy::scan);
	EXPECT_EQ(found.mesh.polygons(), 1u);
	EXPECT_NEAR(measure::measure(set, found.mesh, {}).area, 1.0, 1e-12);
}

TEST(ScanStrategy, BlocksBecomeWhatTheyWouldHaveBeen)
{
	for (const grid::Block* block : listableGrids())
	{
		SCOPED_TRACE(block->name);
		grid::BlockSet set = setOf(listedBlock(*block));
		const Box listed = set.bounds();
		EXPECT_FALSE(grid::hasNeighbors(set));
		EXPECT_EQ(set.cellCount(), std::get<grid::UnstructuredGrid>(block->grid).cellCount());
		grid::buildNeighbors(set);
		EXPECT_TRUE(grid::hasNeighbors(set));
		EXPECT_EQ(set.bounds().lo, listed.lo);
		EXPECT_EQ(set.bounds().hi, listed.hi);
		EXPECT_EQ(set.blocks[0].boundary.faces.size(), block->boundary.faces.size());
		grid::validate(set.blocks[0]);
	}
}

} // namespace vp::test
