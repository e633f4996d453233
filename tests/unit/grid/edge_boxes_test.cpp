#include "grid/link/edge_boxes.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace vp::test
{

namespace
{

// Part of a lattice of 9 x 6 x 5 points, begun at a point: the boxes of its edges one by one.
template <class Number>
void expectBoxesOfEdges(const std::array<std::uint32_t, 3>& cells)
{
	std::mt19937 random(5);
	std::uniform_real_distribution<Number> number(-2, 3);
	std::vector<Number> points(3 * 9 * 6 * 5);
	for (Number& coordinate : points)
		coordinate = number(random);
	const std::array<std::size_t, 3> steps{3, 3 * 9, 3 * 9 * 6};
	const std::size_t first = steps[0] + steps[1];
	const auto boxes = grid::edgeBoxes(points.data() + first, steps[1], steps[2], cells);
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		Box expected;
		for (std::uint32_t k = 0; k < cells[2] + (axis != 2); ++k)
			for (std::uint32_t j = 0; j < cells[1] + (axis != 1); ++j)
				for (std::uint32_t i = 0; i < cells[0] + (axis != 0); ++i)
				{
					const Number* from = &points[first + i * steps[0] + j * steps[1] + k * steps[2]];
					const Number* to = from + steps[axis];
					expected.include(Vec3(to[0] - from[0], to[1] - from[1], to[2] - from[2]));
				}
		EXPECT_EQ(boxes[axis].lo, expected.lo) << axis;
		EXPECT_EQ(boxes[axis].hi, expected.hi) << axis;
	}
}

} // namespace

TEST(EdgeBoxes, HoldEveryEdgeAndNoMore)
{
	for (const std::array<std::uint32_t, 3>& cells :
	     {std::array{4u, 1u, 1u}, std::array{5u, 3u, 2u}, std::array{7u, 4u, 4u}})
	{
		expectBoxesOfEdges<float>(cells);
		expectBoxesOfEdges<double>(cells);
	}
}

} // namespace vp::test
