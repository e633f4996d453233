#include "sliced_sheet.h"
#include "test_grids.h"

#include "grid/demo/demo.h"
#include "mesh/listed_mesh.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

// The outer sphere of the shell as a patch in two parts.
grid::BlockSet shellWithSphere(int n)
{
	grid::BlockSet set = std::move(grid::makeDemo("shell", n).value());
	for (const char* part : {"sphere", "sphere"})
		set.patches.push_back({part, {}, 0});
	for (const grid::BoundaryIndex::Face& face : set.blocks[0].boundary.faces)
		if (face.face == 1)
			set.patches[face.cell % 3 == 0].faces.push_back({0, face.cell, face.face});
	set.patches.push_back({"elsewhere", {}, 0});
	return set;
}

} // namespace

TEST(PatchSurface, IsTheGridSurfaceThere)
{
	constexpr int n = 12;
	const grid::BlockSet set = shellWithSphere(n);
	const auto cells = find::patchCells(set, "sphere");
	const mesh::SheetMesh mesh = mesh::patchMesh(set, "sphere", cells);
	const surface::GridIndex at{0, n};
	const mesh::SheetMesh sphere = mesh::gridIndexMesh(set, at, find::gridIndexCells(set, at));
	EXPECT_EQ(mesh.polygons(), sphere.polygons());
	EXPECT_EQ(mesh.positions.size(), sphere.positions.size());
	EXPECT_EQ(cells[0].cutCells(), std::size_t(n * n));
	const grid::FieldChoice s{"s", grid::Association::point, 0};
	const measure::SheetMeasure ours = measure::measure(set, mesh, s);
	const measure::SheetMeasure theirs = measure::measure(set, sphere, s);
	EXPECT_NEAR(ours.area, theirs.area, 1e-12 * theirs.area);
	EXPECT_NEAR(*ours.mean, *theirs.mean, 1e-9);
	EXPECT_EQ(ours.max, theirs.max);
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		EXPECT_GT(glm::dot(mesh::doubleArea(mesh, mesh.polygon(p)), mesh.positions[mesh.polygon(p)[0]]), 0.0);
}

TEST(PatchSurface, CellsMayBeTurnedDown)
{
	const grid::BlockSet set = shellWithSphere(8);
	const std::vector<grid::CellFilter> filter{[](CellId cell) { return cell > 255; }};
	const auto cells = find::patchCells(set, "sphere", filter);
	EXPECT_EQ(mesh::patchMesh(set, "sphere", cells).polygons(), 32u); // half of the 64
}

TEST(PatchSurface, ANameThatThereIsNotIsTold)
{
	EXPECT_TRUE(find::checkPatch(shellWithSphere(4), "sphere"));
	const Status none = find::checkPatch(shellWithSphere(4), "wall");
	ASSERT_FALSE(none);
	EXPECT_EQ(none.error().kind, ErrorKind::input);
	EXPECT_NE(none.error().message.find("there are sphere, elsewhere"), std::string::npos) << none.error().message;
	EXPECT_FALSE(find::checkPatch(setOf(gridNamed("shell")), "wall"));
	EXPECT_EQ(
	    mesh::patchMesh(shellWithSphere(4), "elsewhere", find::patchCells(shellWithSphere(4), "elsewhere")).polygons(),
	    0u);
}

} // namespace vp::test
