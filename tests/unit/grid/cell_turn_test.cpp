#include "grid/cell_turn.h"
#include "grid/structured.h"
#include "tries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vp::grid
{
namespace
{

using CellCorners = std::vector<Vec3>;

CellCorners unitCell(CellShape shape)
{
	switch (shape)
	{
	case CellShape::tetrahedron:
		return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
	case CellShape::pyramid:
		return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
	case CellShape::wedge:
		return {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}};
	default:
		return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
	}
}

constexpr CellShape kTurnedShapes[] = {CellShape::tetrahedron, CellShape::pyramid, CellShape::wedge,
                                       CellShape::hexahedron};

CellCorners moved(CellCorners corners, const glm::dmat3& by, const Vec3& shift)
{
	for (Vec3& p : corners)
		p = by * p + shift;
	return corners;
}

// The Jacobian of the trilinear map by central differences.
double jacobian(const CellCorners& p, const Vec3& at)
{
	const auto place = [&](const Vec3& x)
	{
		Vec3 sum(0.0);
		for (int i = 0; i < 8; ++i)
		{
			const Vec3 corner = unitCell(CellShape::hexahedron)[i];
			double weight = 1.0;
			for (int a = 0; a < 3; ++a)
				weight *= corner[a] > 0.5 ? x[a] : 1.0 - x[a];
			sum += weight * p[i];
		}
		return sum;
	};
	glm::dmat3 m;
	for (int a = 0; a < 3; ++a)
	{
		Vec3 step(0.0);
		step[a] = 0.25; // exact for what is linear along each axis
		m[a] = (place(at + step) - place(at - step)) / 0.5;
	}
	return glm::determinant(m);
}

TEST(CellTurn, OfAnyAffineImage)
{
	std::mt19937 random(1);
	std::uniform_real_distribution<double> number(-1.0, 1.0);
	for (int n = 0; n < 500; ++n)
	{
		glm::dmat3 by;
		for (int column = 0; column < 3; ++column)
			by[column] = Vec3(number(random), number(random), number(random));
		by[n % 3] *= std::pow(10.0, -(n % 7)); // thin by up to 1e6
		for (const CellShape shape : kTurnedShapes)
			EXPECT_EQ(turnOf(shape, moved(unitCell(shape), by, Vec3(n % 5))),
			          glm::determinant(by) > 0.0 ? Turn::positive : Turn::negative);
	}
}

TEST(CellTurn, GoodCornersAreNotEnough)
{
	// 2 x 1 below, 1 x 2 turned by 180 degrees above.
	const CellCorners brick = {{-1, -0.5, 0}, {1, -0.5, 0}, {1, 0.5, 0},   {-1, 0.5, 0},
	                           {0.5, 1, 1},   {-0.5, 1, 1}, {-0.5, -1, 1}, {0.5, -1, 1}};
	for (const CornerFrame& frame : cornerFrames(CellShape::hexahedron))
	{
		const auto edge = [&](int i) { return brick[frame.corner[i]] - brick[frame.corner[0]]; };
		EXPECT_GT(glm::dot(edge(1), glm::cross(edge(2), edge(3))), 0.0);
	}
	EXPECT_LT(jacobian(brick, Vec3(0.5)), 0.0);
	EXPECT_EQ(turnOf(CellShape::hexahedron, brick), Turn::mixed);
	CellCorners wedge = {{0, 0, 0}, {0, 1, 0}, {3, 0, 0}, {0, 0, 1}, {0, 3, 1}, {1, 0, 1}};
	EXPECT_EQ(turnOf(CellShape::wedge, wedge), Turn::positive);
	for (int i = 3; i < 6; ++i)
		wedge[i] = {-wedge[i].x, -wedge[i].y, 1.0};
	EXPECT_EQ(turnOf(CellShape::wedge, wedge), Turn::mixed);
}

// A cell that is called positive is so at every point. A cell that is mixed and not flat is mostly so too.
TEST(CellTurn, OfHexahedraIsTheSignOfTheJacobian)
{
	std::mt19937 random(2);
	std::uniform_real_distribution<double> unit(0.0, 1.0);
	std::uniform_real_distribution<double> jitter(-0.6, 0.6);
	const int cells = test::tries(3000);
	int settled = 0;
	int mixed_but_one_sign = 0;
	for (int n = 0; n < cells; ++n)
	{
		CellCorners p = unitCell(CellShape::hexahedron);
		for (Vec3& corner : p)
			corner += (n % 10) / 10.0 * Vec3(jitter(random), jitter(random), jitter(random));
		const Turn turn = turnOf(CellShape::hexahedron, p);
		bool positive = false;
		bool negative = false;
		const auto see = [&](const Vec3& at) { (jacobian(p, at) > 0.0 ? positive : negative) = true; };
		for (const Vec3& corner : unitCell(CellShape::hexahedron))
			see(corner);
		for (int i = 0; i < 100; ++i)
			see({unit(random), unit(random), unit(random)});
		settled += turn != Turn::mixed;
		mixed_but_one_sign += turn == Turn::mixed && positive != negative;
		EXPECT_TRUE(turn != Turn::positive || !negative);
		EXPECT_TRUE(turn != Turn::negative || !positive);
	}
	EXPECT_GT(settled, cells / 2);
	EXPECT_LT(mixed_but_one_sign, cells / 20);
}

TEST(CellTurn, FlatAndCollapsedCells)
{
	CellCorners flat = unitCell(CellShape::hexahedron);
	for (Vec3& p : flat)
		p.z = 0.0;
	EXPECT_EQ(turnOf(CellShape::hexahedron, flat), Turn::mixed);
	// An edge drawn to a point leaves a wedge that is turned one way.
	CellCorners drawn = unitCell(CellShape::hexahedron);
	drawn[3] = drawn[0];
	drawn[7] = drawn[4];
	EXPECT_EQ(turnOf(CellShape::hexahedron, drawn), Turn::positive);
}

TEST(CellTurn, OfManyEdgesAtOnce)
{
	const auto around = [](const Vec3& center, double reach) { return Box{center - reach, center + reach}; };
	EXPECT_EQ(turnOfEdges(around({1, 0, 0}, 0.2), around({0, 1, 0}, 0.2), around({0, 0, 1}, 0.2)), Turn::positive);
	EXPECT_EQ(turnOfEdges(around({0, 1, 0}, 0.2), around({1, 0, 0}, 0.2), around({0, 0, 1}, 0.2)), Turn::negative);
	EXPECT_EQ(turnOfEdges(around({1, 0, 0}, 0.6), around({0, 1, 0}, 0.6), around({0, 0, 1}, 0.6)), Turn::mixed);
	EXPECT_EQ(turnOfEdges(around({1, 0, 0}, 0.2), around({0, 1, 0}, 0.2), around({0, 0, 1e-6}, 1e-7)), Turn::positive);
}

} // namespace
} // namespace vp::grid
