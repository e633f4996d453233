#include "all_pieces.h"
#include "contour/box_contour.h"
#include "grown.h"
#include "random_window.h"
#include "seamed_sets.h"

#include "grid/demo/demo.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <random>

namespace vp::test
{

namespace
{

double areaOf(const grid::BlockSet& set, const mesh::SheetMesh& mesh)
{
	return measure::measure(set, mesh, {}).area;
}

std::set<std::pair<std::size_t, CellId>> cellsOf(const mesh::SheetMesh& mesh)
{
	std::set<std::pair<std::size_t, CellId>> cells;
	for (const mesh::BlockCell& from : mesh.polygon_cells)
		cells.emplace(from.block, from.cell);
	return cells;
}

// Sides that one polygon alone has: both their ends.
std::vector<std::pair<std::uint32_t, std::uint32_t>> openSides(const mesh::SheetMesh& mesh)
{
	std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto corners = mesh.polygon(p);
		for (std::size_t i = 0; i < corners.size(); ++i)
			++sides[std::minmax(corners[i], corners[(i + 1) % corners.size()])];
	}
	std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
	for (const auto& [side, count] : sides)
		if (count == 1)
			open.push_back(side);
	return open;
}

// Lie both on one side of the box.
bool onRim(const contour::ClipBox& box, const Vec3& a, const Vec3& b)
{
	constexpr double kSlack = 1e-9;
	const Vec3 at[] = {box.inBox(a), box.inBox(b)};
	for (int axis = 0; axis < 3; ++axis)
		for (const double bound : {box.lo()[axis], box.hi()[axis]})
			if (std::abs(at[0][axis] - bound) < kSlack && std::abs(at[1][axis] - bound) < kSlack)
				return true;
	return false;
}

double within(const std::optional<std::pair<double, double>>& range, std::mt19937& random)
{
	return std::uniform_real_distribution<double>(range->first, range->second)(random);
}

grid::Block imageOfRadius(int n)
{
	return withHills(grid::makeDemo("blob", n)->blocks[0], [](const Vec3& p) { return glm::length(p); });
}

} // namespace

TEST(BoxContour, IsWhatAScanOfAllCellsFindsOnTheSheet)
{
	std::mt19937 random(17);
	std::size_t grown = 0;
	std::size_t of_several = 0;
	for (const grid::Block& plain : allGrids())
	{
		// Its mesh hangs together along an edge, and across a face of three cells: no traversal goes there.
		if (plain.name == "three_on_a_face")
			continue;
		SCOPED_TRACE(plain.name);
		const grid::BlockSet set = setOf(withHills(plain));
		cut::Cutter cutter(set);
		const double size = set.bounds().diagonal();
		for (const TestPlane& plane : randomPlanes(set.bounds(), 12, 18))
		{
			const bool windowed = random() % 4 != 0;
			const double depth = size * std::pow(10.0, std::uniform_real_distribution<double>(-2.0, 0.0)(random));
			const SheetOfHills sheet(
			    cutter, plane, windowed ? std::optional(randomWindow(set.bounds(), random)) : std::nullopt, depth);
			if (!sheet.contourer.range())
				continue;
			const double value = within(sheet.contourer.range(), random);
			const contour::Contour contour = sheet.contourer.grow(value).value();
			const PiecesOnSheet expected = piecesOnSheet(set, "hills", value, sheet.contourer.box());
			EXPECT_EQ(cellsOf(contour.mesh), expected.cells);
			EXPECT_EQ(contour.mesh.polygons(), expected.polygons);
			EXPECT_EQ(contour.components, expected.pieces);
			EXPECT_NEAR(areaOf(set, contour.mesh), expected.area, 1e-9 * size * size);
			grown += contour.cells > 1;
			of_several += contour.components > 1;
		}
	}
	EXPECT_GT(grown, 60u);
	EXPECT_GT(of_several, 5u);
}

TEST(BoxContour, HasNoHolesButOnTheBoxesSides)
{
	const grid::BlockSet set = setOf(imageOfRadius(24));
	cut::Cutter cutter(set);
	std::mt19937 random(3);
	std::size_t polygons = 0;
	for (const TestPlane& plane : randomPlanes(set.bounds(), 60, 4))
	{
		const double side = std::uniform_real_distribution<double>(0.4, 3.0)(random);
		const SheetOfHills sheet(cutter, plane, probe::centeredWindow(side, 0.8 * side), std::nullopt);
		if (!sheet.contourer.range())
			continue;
		const double value = within(sheet.contourer.range(), random);
		if (value > 2.9)
			continue; // past the grid's faces
		const contour::Contour contour = sheet.contourer.grow(value).value();
		for (const auto& [a, b] : openSides(contour.mesh))
			EXPECT_TRUE(onRim(sheet.contourer.box(), contour.mesh.positions[a], contour.mesh.positions[b]));
		polygons += contour.mesh.polygons();
	}
	EXPECT_GT(polygons, 500u);
}

// The zone of a sphere between two planes: 2 pi R d.
TEST(BoxContour, AreaOfASpheresZoneConverges)
{
	constexpr double kRadius = 1.7;
	constexpr double kDepth = 0.9;
	const double zone = 2.0 * std::numbers::pi * kRadius * kDepth;
	double error[2];
	for (int fine = 0; fine < 2; ++fine)
	{
		const grid::BlockSet set = setOf(imageOfRadius(fine ? 80 : 40));
		cut::Cutter cutter(set);
		const SheetOfHills sheet(cutter, {{0.03, -0.02, 0.01}, {0.3, 0.5, 0.81}}, probe::centeredWindow(5.0, 5.0),
		                         kDepth);
		const contour::Contour contour = sheet.contourer.grow(kRadius).value();
		EXPECT_EQ(contour.components, 1u);
		error[fine] = std::abs(areaOf(set, contour.mesh) - zone) / zone;
	}
	EXPECT_LT(error[0], 0.01);
	EXPECT_LT(error[1], 0.3 * error[0]); // N^-2 on a side
}

TEST(BoxContour, WorkFollowsTheBox)
{
	const grid::BlockSet set = setOf(imageOfRadius(96));
	cut::Cutter cutter(set);
	const TestPlane plane{{1.5, 0.0, 0.0}, {0.0, 0.0, 1.0}};
	const SheetOfHills small(cutter, plane, probe::centeredWindow(0.6, 0.6), std::nullopt);
	const contour::Contour contour = small.contourer.grow(1.5).value();
	EXPECT_GT(contour.cells, 60u);
	// The surface in the box, and a rim of cells about it.
	EXPECT_LT(contour.cells_touched, 2 * contour.cells);
	EXPECT_GT(contour.generations, 2u);
	EXPECT_GT(contour.seeds, 5u);
	EXPECT_LT(contour.seeds, contour.cells);
}

TEST(BoxContour, DefaultDepthIsOfTheSmallerSide)
{
	const grid::BlockSet set = setOf(imageOfRadius(16));
	cut::Cutter cutter(set);
	const TestPlane plane{{0.0, 0.0, 0.1}, {0.0, 0.0, 1.0}};
	const SheetOfHills windowed(cutter, plane, probe::Window{-1.0, 1.5, 0.0, 2.0}, std::nullopt);
	EXPECT_EQ(windowed.contourer.box().lo(), Vec3(-1.0, 0.0, -1.0));
	EXPECT_EQ(windowed.contourer.box().hi(), Vec3(1.5, 2.0, 1.0));
	const SheetOfHills whole(cutter, plane, std::nullopt, std::nullopt);
	EXPECT_NEAR(whole.contourer.box().lo().x, -3.0, 1e-12);
	EXPECT_NEAR(whole.contourer.box().hi().z, 1.5, 1e-12);
	const SheetOfHills deep(cutter, plane, std::nullopt, 0.5);
	EXPECT_EQ(deep.contourer.box().hi().z, 0.25);
}

TEST(BoxContour, ValuesOffTheSheetGiveNothing)
{
	const grid::BlockSet set = setOf(imageOfRadius(16));
	cut::Cutter cutter(set);
	const SheetOfHills sheet(cutter, {{0.0, 0.0, 0.1}, {0.0, 0.0, 1.0}}, probe::centeredWindow(1.0, 1.0), 5.0);
	// In the box, but never on the sheet.
	EXPECT_LT(sheet.contourer.range()->second, 1.5);
	const contour::Contour contour = sheet.contourer.grow(1.5).value();
	EXPECT_EQ(contour.mesh.polygons(), 0u);
	EXPECT_EQ(contour.cells_touched, 0u);
}

TEST(BoxContour, CellsWithNanAreLeftOut)
{
	const grid::Block plain = grid::makeDemo("blob", 24)->blocks[0];
	const auto height = [](const Vec3& p) { return p.x > 0.4 ? std::nan("") : glm::length(p); };
	const grid::BlockSet set = setOf(withHills(plain, height));
	cut::Cutter cutter(set);
	const SheetOfHills sheet(cutter, {{0.0, 0.0, 0.1}, {0.0, 0.0, 1.0}}, std::nullopt, 6.0);
	const contour::Contour contour = sheet.contourer.grow(2.0).value();
	EXPECT_GT(contour.mesh.polygons(), 50u);
	for (const Vec3& p : contour.mesh.positions)
	{
		EXPECT_LE(p.x, 0.4);
		EXPECT_NEAR(glm::length(p), 2.0, 0.02);
	}
}

TEST(BoxContour, CrossesSeams)
{
	const auto height = [](const Vec3& p) { return p.y + 0.4 * std::sin(1.5 * p.x) * (1.0 + p.z); };
	const grid::BlockSet two = setOfBlocks(
	    {withHills(latticeBlock(warped, 0.0, false), height), withHills(latticeBlock(warped, 1.0, true), height)});
	const grid::BlockSet one = setOf(withHills(hexahedraBlock(warped, 0.0, 2.0, true), height));
	cut::Cutter of_two(two);
	cut::Cutter of_one(one);
	std::size_t both = 0;
	for (const TestPlane& plane : randomPlanes(one.bounds(), 20, 5))
	{
		const SheetOfHills here(of_two, plane, std::nullopt, 0.4);
		const SheetOfHills there(of_one, plane, std::nullopt, 0.4);
		if (!there.contourer.range())
			continue;
		const double value = 0.5 * (there.contourer.range()->first + there.contourer.range()->second);
		const contour::Contour contour = here.contourer.grow(value).value();
		const contour::Contour expected = there.contourer.grow(value).value();
		EXPECT_EQ(contour.cells, expected.cells);
		EXPECT_EQ(contour.components, expected.components);
		EXPECT_NEAR(areaOf(two, contour.mesh), areaOf(one, expected.mesh), 1e-9);
		std::set<std::uint32_t> blocks;
		for (const mesh::BlockCell& from : contour.mesh.polygon_cells)
			blocks.insert(from.block);
		both += blocks.size() == 2;
	}
	EXPECT_GT(both, 5u);
}

} // namespace vp::test
