#include "exhaustive.h"
#include "test_grids.h"

#include "locate/interpolate.h"

#include <gtest/gtest.h>

#include <numeric>

namespace vp::test
{

namespace
{

using grid::CellShape;
using locate::CellWeights;

struct Reference
{
	CellShape shape;
	std::vector<Vec3> points;
};

// VTK's parametric coordinates of the points.
const std::vector<Reference>& references()
{
	static const std::vector<Reference> all{
	    {CellShape::tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
	    {CellShape::pyramid, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}},
	    {CellShape::wedge, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
	    {CellShape::hexahedron,
	     {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}};
	return all;
}

struct Treatment
{
	double warp, thickness, size, offset;
};

// Skewed and warped, flattened, tiny, far away.
constexpr std::array<Treatment, 6> kTreatments{{{0.0, 1.0, 1.0, 0.0},
                                                {0.12, 1.0, 1.0, 0.0},
                                                {0.12, 1.0, 1e-6, 0.0},
                                                {0.12, 1e-5, 1.0, 0.0},
                                                {0.12, 1.0, 1.0, 1e7},
                                                {0.12, 1.0, 1e6, -1e7}}};

std::vector<Vec3> treated(const Reference& cell, const Treatment& how, std::mt19937& random)
{
	std::uniform_real_distribution<double> moved(-how.warp, how.warp);
	std::vector<Vec3> points;
	for (const Vec3& p : cell.points)
	{
		Vec3 q = p;
		for (int axis = 0; axis < 3; ++axis)
			q[axis] += moved(random);
		q = {q.x + 0.4 * q.y - 0.3 * q.z, 1.3 * q.y + 0.2 * q.z, q.z * how.thickness};
		points.push_back(how.size * q + how.offset);
	}
	return points;
}

// A place inside the cell: the points' mean by random weights.
Vec3 mixed(std::span<const Vec3> points, std::mt19937& random)
{
	std::uniform_real_distribution<double> any(0.3, 1.0);
	Vec3 sum(0.0);
	double all = 0.0;
	for (const Vec3& p : points)
	{
		const double w = any(random);
		sum += w * (p - points[0]);
		all += w;
	}
	return points[0] + sum / all;
}

Vec3 placeOf(const grid::Block& block, const CellWeights& weights, const Vec3& origin)
{
	return visitGrid(block,
	                 [&](const auto& grid)
	                 {
		                 Vec3 sum(0.0);
		                 for (std::size_t i = 0; i < weights.points.size(); ++i)
			                 sum += weights.weights[i] * (grid.point(weights.points[i]) - origin);
		                 return origin + sum;
	                 });
}

double sumOf(const CellWeights& weights)
{
	return std::accumulate(weights.weights.begin(), weights.weights.end(), 0.0);
}

// Anything but linear.
double curvedAt(const Vec3& p)
{
	return std::sin(5.0 * p.x) + p.y * p.z * p.z;
}

double valueOf(const grid::Block& block, const CellWeights& weights)
{
	return visitGrid(block,
	                 [&](const auto& grid)
	                 {
		                 double sum = 0.0;
		                 for (std::size_t i = 0; i < weights.points.size(); ++i)
			                 sum += weights.weights[i] * curvedAt(grid.point(weights.points[i]));
		                 return sum;
	                 });
}

} // namespace

// The place itself is a linear field.
TEST(Interpolate, GivesThePlaceBackInCellsOfAnyShape)
{
	for (const Reference& cell : references())
		for (const Treatment& how : kTreatments)
		{
			std::mt19937 random(11);
			for (int i = 0; i < 200; ++i)
			{
				const std::vector<Vec3> points = treated(cell, how, random);
				const Vec3 place = mixed(points, random);
				const auto weights = locate::shapeWeights(cell.shape, points, place);
				ASSERT_TRUE(weights) << shapeName(cell.shape) << " " << how.size << " " << how.thickness;
				EXPECT_GT(weights->depth, 0.0) << shapeName(cell.shape);
				Vec3 back(0.0);
				double sum = 0.0;
				for (std::size_t p = 0; p < points.size(); ++p)
				{
					back += weights->weight[p] * (points[p] - points[0]);
					sum += weights->weight[p];
				}
				EXPECT_NEAR(sum, 1.0, 1e-14);
				EXPECT_LT(glm::length(back - (place - points[0])), 1e-14 * how.size) << shapeName(cell.shape);
			}
		}
}

TEST(Interpolate, ACornerIsItself)
{
	for (const Reference& cell : references())
		for (const Treatment& how : kTreatments)
		{
			std::mt19937 random(12);
			const std::vector<Vec3> points = treated(cell, how, random);
			for (std::size_t corner = 0; corner < points.size(); ++corner)
			{
				const auto weights = locate::shapeWeights(cell.shape, points, points[corner]);
				ASSERT_TRUE(weights) << shapeName(cell.shape) << corner;
				EXPECT_NEAR(weights->depth, 0.0, 1e-9);
				for (std::size_t p = 0; p < points.size(); ++p)
					EXPECT_NEAR(weights->weight[p], p == corner, 1e-9) << shapeName(cell.shape) << corner;
			}
		}
}

TEST(Interpolate, BeyondAFaceIsOutside)
{
	for (const Reference& cell : references())
	{
		const auto& shape = grid::topology(cell.shape);
		const Vec3 middle = std::accumulate(cell.points.begin(), cell.points.end(), Vec3(0.0)) /
		                    static_cast<double>(cell.points.size());
		for (int f = 0; f < shape.faces; ++f)
		{
			Vec3 face(0.0);
			for (const std::uint8_t p : shape.facePoints(f))
				face += cell.points[p] / static_cast<double>(shape.face_size[f]);
			const auto at = [&](double t)
			{ return locate::shapeWeights(cell.shape, cell.points, glm::mix(middle, face, t))->depth; };
			EXPECT_GT(at(0.9), 0.0);
			EXPECT_NEAR(at(1.0), 0.0, 1e-12);
			EXPECT_LT(at(1.1), 0.0);
		}
	}
}

// Polyhedra, collapsed and inverted cells too.
TEST(Interpolate, GivesThePlaceBackInAllGrids)
{
	for (const grid::Block& block : allGrids())
	{
		std::mt19937 random(13);
		CellWeights weights;
		for (CellId c = 0; c < cellCount(block); ++c)
			for (const Tetrahedron& part : cellTetrahedra(block, c))
			{
				if (std::abs(volumeOf(part)) < 1e-12)
					continue;
				const Vec3 place = mixed(part, random);
				locate::weighCell(block, c, place, weights);
				ASSERT_EQ(weights.points.size(), weights.weights.size());
				EXPECT_NEAR(sumOf(weights), 1.0, 1e-12) << block.name << " " << c;
				EXPECT_LT(glm::length(placeOf(block, weights, part[0]) - place), 1e-11) << block.name << " " << c;
			}
	}
}

// Cells that share a face give a place on it the same value, whatever the field; a polyhedron and a hexahedron fill
// their common quad differently and are left out.
TEST(Interpolate, IsContinuousAcrossFaces)
{
	for (const char* name : {"blob", "shell", "tets", "mixed", "warped_curvilinear", "hexagonal_prisms"})
	{
		const grid::Block& block = gridNamed(name);
		int faces_seen = 0;
		std::mt19937 random(14);
		visitGrid(block,
		          [&](const auto& grid)
		          {
			          grid::CellFaces faces;
			          CellWeights here;
			          CellWeights there;
			          for (CellId c = 0; c < grid.cellCount(); ++c)
			          {
				          grid.cellFaces(c, faces);
				          for (int f = 0; f < faces.size(); ++f)
				          {
					          Vec3 middle(0.0);
					          for (const PointId p : faces[f])
						          middle += grid.point(p) / static_cast<double>(faces[f].size());
					          // On an edge of the fan about a quad's mean, which both the fan and the bilinear
					          // surface run through.
					          const Vec3 place =
					              faces[f].size() == 3 ? glm::mix(middle, grid.point(faces[f][0]), 0.37) : middle;
					          grid.forEachNeighbor(c, f,
					                               [&](CellId n)
					                               {
						                               locate::weighCell(block, c, place, here);
						                               locate::weighCell(block, n, place, there);
						                               EXPECT_NEAR(valueOf(block, here), valueOf(block, there), 1e-10)
						                                   << name;
						                               ++faces_seen;
					                               });
				          }
			          }
		          });
		EXPECT_GT(faces_seen, 10) << name;
	}
}

TEST(Interpolate, ACellWithoutVolumeHoldsNothing)
{
	const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
	EXPECT_FALSE(locate::shapeWeights(CellShape::tetrahedron, flat, {0.3, 0.3, 0.0}));
	CellListMaker maker;
	for (const Vec3& p : flat)
		maker.point(p);
	maker.cell(10, {0, 1, 2, 3});
	const grid::Block block = maker.block("flat");
	CellWeights weights;
	locate::weighCell(block, 0, {0.3, 0.3, 0.0}, weights);
	EXPECT_LT(weights.depth, -1e300);
	EXPECT_TRUE(weights.points.empty());
}

} // namespace vp::test
