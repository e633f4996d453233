#include "locate/cell_polynomial.h"
#include "locate/interpolate.h"

#include <gtest/gtest.h>

#include <random>

namespace vp::test
{

namespace
{

using grid::CellShape;
using grid::ShapeTopology;

constexpr CellShape kShapes[] = {CellShape::tetrahedron, CellShape::pyramid, CellShape::wedge, CellShape::hexahedron};

// VTK's corners in the cell's own coordinates; a pyramid's tip is (0, 0, 1).
std::vector<Vec3> cornersOf(CellShape shape)
{
	switch (shape)
	{
	case CellShape::tetrahedron:
		return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
	case CellShape::pyramid:
		return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
	case CellShape::wedge:
		return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
	default:
		return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
	}
}

} // namespace

TEST(CellPolynomial, IsTheSumOfTheShapeFunctions)
{
	std::mt19937 random(7);
	std::uniform_real_distribution<double> moved(-0.15, 0.15);
	std::uniform_real_distribution<double> any(0.2, 1.0);
	for (const CellShape shape : kShapes)
		for (int i = 0; i < 200; ++i)
		{
			std::vector<Vec3> corners = cornersOf(shape);
			std::vector<Vec3> values;
			Vec3 place(0.0);
			double all = 0.0;
			for (Vec3& corner : corners)
			{
				corner += Vec3(moved(random), moved(random), moved(random));
				values.emplace_back(any(random), any(random), any(random));
				const double weight = any(random);
				place += weight * corner;
				all += weight;
			}
			place /= all;
			const auto weights = locate::shapeWeights(shape, corners, place);
			ASSERT_TRUE(weights);
			Vec3 expected(0.0);
			for (std::size_t c = 0; c < corners.size(); ++c)
				expected += weights->weight[c] * values[c];
			Vec3 u = locate::middleOf(shape);
			ASSERT_TRUE(locate::findPlace(locate::cellPolynomial(shape, corners), shape, place, u));
			EXPECT_LT(glm::length(locate::cellPolynomial(shape, values).at(shape, u) - expected), 1e-8)
			    << shapeName(shape);
			EXPECT_NEAR(locate::faceDepths(shape, u).least(), weights->depth, 1e-8);
		}
}

TEST(CellPolynomial, SlopesAreItsDerivatives)
{
	std::mt19937 random(8);
	std::uniform_real_distribution<double> any(-1.0, 1.0);
	for (const CellShape shape : kShapes)
	{
		std::vector<Vec3> values(cornersOf(shape).size());
		for (Vec3& value : values)
			value = Vec3(any(random), any(random), any(random));
		const locate::CellPolynomial of = locate::cellPolynomial(shape, values);
		const Vec3 u(0.2, 0.3, 0.25);
		constexpr double kStep = 1e-5;
		const auto slopes = of.slopesAt(shape, u);
		for (int axis = 0; axis < 3; ++axis)
		{
			Vec3 step(0.0);
			step[axis] = kStep;
			const Vec3 expected = (of.at(shape, u + step) - of.at(shape, u - step)) / (2.0 * kStep);
			EXPECT_LT(glm::length(slopes[axis] - expected), 1e-8) << shapeName(shape);
		}
	}
}

// A face's own points lie at no depth behind it, all others at some.
TEST(FaceDepths, AreThoseOfTheTopologysFaces)
{
	for (const CellShape shape : kShapes)
	{
		const ShapeTopology& table = grid::topology(shape);
		const std::vector<Vec3> corners = cornersOf(shape);
		for (int f = 0; f < table.faces; ++f)
			for (int c = 0; c < table.points; ++c)
			{
				const auto on = table.facePoints(f);
				const bool of_face = std::ranges::find(on, c) != on.end();
				EXPECT_EQ(locate::faceDepths(shape, corners[c]).of[f], of_face ? 0.0 : 1.0)
				    << shapeName(shape) << " " << f << " " << c;
			}
		for (int f = table.faces; f < grid::kMaxShapeFaces; ++f)
			EXPECT_EQ(locate::faceDepths(shape, corners[0]).of[f], HUGE_VAL);
	}
}

TEST(FindPlace, SaysWhereItFindsNone)
{
	const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
	const auto places = locate::cellPolynomial(CellShape::tetrahedron, flat);
	Vec3 u(0.25);
	EXPECT_FALSE(locate::findPlace(places, CellShape::tetrahedron, {0.2, 0.2, 0.5}, u));
}

} // namespace vp::test
