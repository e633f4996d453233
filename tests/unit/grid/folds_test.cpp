// Where a grid may be folded over: cells of table shapes among their neighbors, and polyhedra, whose faces files list
// either way round.
#include "grid/link/folds.h"

#include "test_grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace vp::grid
{
namespace
{

using test::CellListMaker;
using Ids = std::vector<std::int64_t>;

constexpr std::uint8_t kVtkTetra = 10;

std::size_t folds(const CellListMaker& maker)
{
	const Block block = maker.block("folds");
	return foldedCells(std::get<UnstructuredGrid>(block.grid)).size();
}

// As a polyhedron, with every second face the other way round.
void addTetrahedron(CellListMaker& maker, const Ids& p)
{
	maker.polyhedron({{p[0], p[1], p[2]}, {p[0], p[1], p[3]}, {p[3], p[2], p[1]}, {p[0], p[2], p[3]}});
}

// Over a polygon in a plane z, up to z + 1. Gives the points on top.
Ids addPrism(CellListMaker& maker, const Ids& bottom, const std::vector<Vec3>& corners, double z)
{
	Ids top;
	for (const Vec3& corner : corners)
		top.push_back(maker.point({corner.x, corner.y, z + 1.0}));
	std::vector<Ids> faces{bottom, top};
	for (std::size_t i = 0; i < bottom.size(); ++i)
	{
		const std::size_t next = (i + 1) % bottom.size();
		faces.push_back({bottom[i], bottom[next], top[next], top[i]});
	}
	maker.polyhedron(faces);
	return top;
}

Ids bottomOf(CellListMaker& maker, const std::vector<Vec3>& corners)
{
	Ids bottom;
	for (const Vec3& corner : corners)
		bottom.push_back(maker.point(corner));
	return bottom;
}

} // namespace

// Eight tetrahedra around the center of an octahedron, as polyhedra and as tetrahedra of either sense.
TEST(Folds, AroundAPoint)
{
	for (const bool polyhedra : {true, false})
	{
		CellListMaker maker;
		const std::int64_t center = maker.point(Vec3(0.0));
		Ids ends;
		for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
			for (const double sign : {1.0, -1.0})
				ends.push_back(maker.point(sign * axis));
		for (std::size_t corner = 0; corner < 8; ++corner)
		{
			const Ids points{ends[corner & 1], ends[2 + (corner >> 1 & 1)], ends[4 + (corner >> 2)], center};
			if (polyhedra)
				addTetrahedron(maker, points);
			else
				maker.cell(kVtkTetra, points);
		}
		EXPECT_EQ(folds(maker), 0u) << polyhedra;
	}
}

// Two cells on the same side of the face that they share.
TEST(Folds, OnOneSideOfAFace)
{
	for (const bool polyhedra : {true, false})
	{
		CellListMaker maker;
		const Ids face{maker.point({0, 0, 0}), maker.point({1, 0, 0}), maker.point({0, 1, 0})};
		std::vector<Ids> cells;
		for (const Vec3& top : {Vec3(0.2, 0.2, 1), Vec3(0.3, 0.3, 2)})
			cells.push_back({face[0], face[1], face[2], maker.point(top)});
		if (!polyhedra)
			std::swap(cells[1][0], cells[1][1]); // as if it lay on the other side
		for (const Ids& cell : cells)
			if (polyhedra)
				addTetrahedron(maker, cell);
			else
				maker.cell(kVtkTetra, cell);
		EXPECT_EQ(folds(maker), polyhedra ? 2u : 1u);
	}
}

TEST(Folds, PrismsOverPolygons)
{
	std::vector<Vec3> pentagon;
	for (int i = 0; i < 5; ++i)
		pentagon.push_back({std::cos(0.4 * std::numbers::pi * i), std::sin(0.4 * std::numbers::pi * i), 0.0});
	CellListMaker sound;
	const Ids middle = addPrism(sound, bottomOf(sound, pentagon), pentagon, 0.0);
	addPrism(sound, middle, pentagon, 1.0);
	EXPECT_EQ(folds(sound), 0u);

	// Its center lies outside it.
	const std::vector<Vec3> angle{{0, 0, 0}, {4, 0, 0}, {4, 0.5, 0}, {0.5, 0.5, 0}, {0.5, 4, 0}, {0, 4, 0}};
	CellListMaker concave;
	addPrism(concave, bottomOf(concave, angle), angle, 0.0);
	EXPECT_EQ(folds(concave), 1u);
}

// Lattices whose axes run forth and back again.
TEST(Folds, AxesThatTurnBack)
{
	const Array<double> steady({0.0, 1.0, 2.0, 4.0});
	const RectilinearGrid sound(steady, steady, steady);
	EXPECT_TRUE(foldedCells(sound).empty());
	const RectilinearGrid turned(Array<double>({0.0, 2.0, 1.0, 3.0}), steady, steady);
	const std::vector<CellId> cells = foldedCells(turned);
	ASSERT_EQ(cells.size(), 9u);
	for (std::size_t i = 0; i < cells.size(); ++i)
		EXPECT_EQ(cells[i], 3 * i + 1);
}

} // namespace vp::grid
