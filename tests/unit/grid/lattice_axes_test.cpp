#include "grid/block.h"
#include "grid/lattice_cells.h"
#include "grid/link/lattice_axes.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

using Counts = std::array<std::uint32_t, 3>;

// A sheared box of points, `edge` apart along each axis.
template <class Number>
grid::CurvilinearGrid boxOf(const Counts& points, const Vec3& edge)
{
	std::vector<Number> xyz;
	for (std::uint32_t k = 0; k < points[2]; ++k)
		for (std::uint32_t j = 0; j < points[1]; ++j)
			for (std::uint32_t i = 0; i < points[0]; ++i)
				for (const double x : {i * edge.x + 0.1 * k, j * edge.y, k * edge.z})
					xyz.push_back(static_cast<Number>(x));
	return {points, grid::Points(Array<Number>(std::move(xyz)))};
}

template <class Number>
void expectTurned(const Vec3& edge, const std::array<std::uint8_t, 3>& axes)
{
	const Counts points = {4, 5, 6};
	const grid::CurvilinearGrid given = boxOf<Number>(points, edge);
	const grid::CurvilinearGrid turned = grid::withShortestEdgesFirst(given);
	ASSERT_EQ(turned.axes(), axes);
	ASSERT_EQ(turned.pointCount(), given.pointCount());
	EXPECT_EQ(turned.sourceLattice().points(), points);
	for (PointId p = 0; p < turned.pointCount(); ++p)
		EXPECT_EQ(turned.point(p), given.point(static_cast<PointId>(turned.sourcePoint(p))));
	for (CellId c = 0; c < turned.cellCount(); ++c)
	{
		const grid::CellPoints here = turned.cellPoints(c);
		std::vector<std::size_t> of_source;
		for (const PointId p : here)
			of_source.push_back(turned.sourcePoint(p));
		const grid::CellPoints there = given.cellPoints(static_cast<CellId>(turned.sourceCell(c)));
		EXPECT_TRUE(std::is_permutation(of_source.begin(), of_source.end(), there.begin(), there.end()));
		// The edges at the first point keep their sense.
		const auto volume = [](const grid::CurvilinearGrid& grid, const grid::CellPoints& at)
		{
			const Vec3 o = grid.point(at.id[0]);
			return glm::dot(glm::cross(grid.point(at.id[1]) - o, grid.point(at.id[3]) - o), grid.point(at.id[4]) - o);
		};
		EXPECT_NEAR(volume(turned, here), volume(given, there), 1e-5);
	}
	const grid::LatticeCells cells(turned);
	for (int axis = 0; axis < 3; ++axis)
		EXPECT_EQ(axes[static_cast<std::size_t>(cells.axisInCells(axis))], axis);
	for (CellId c = 0; c < given.cellCount(); ++c)
		EXPECT_EQ(turned.sourceCell(cells.at(given.cellIndex(c))), c);
}

} // namespace

TEST(LatticeAxes, TheShortestEdgesRunFastest)
{
	expectTurned<float>({1.0, 2.0, 3.0}, {0, 1, 2});
	expectTurned<float>({3.0, 1.0, 2.0}, {1, 2, 0});
	expectTurned<double>({3.0, 1.0, 2.0}, {1, 2, 0});
	expectTurned<float>({3.0, 2.0, 1.0}, {2, 0, 1});
	expectTurned<double>({3.0, 2.0, 1.0}, {2, 0, 1});
	expectTurned<float>({1.1, 1.0, 1.0}, {0, 1, 2}); // not worth a copy
}

TEST(LatticeAxes, AGridWithoutCellsStays)
{
	const grid::CurvilinearGrid flat = boxOf<float>({4, 5, 1}, {3.0, 1.0, 1.0});
	EXPECT_EQ(grid::withShortestEdgesFirst(flat).points(), flat.points());
}

} // namespace vp::test
