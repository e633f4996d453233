#include "grid/cell_shape.h"
#include "locate/interpolate.h"

#include <gtest/gtest.h>

#include <vtkHexahedron.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPyramid.h>
#include <vtkTetra.h>
#include <vtkWedge.h>

#include <random>

namespace vp::test
{

namespace
{

// The weights that VTK finds for places inside cells whose corners are moved at random.
template <class VtkCell>
void compareShape(grid::CellShape shape)
{
	vtkNew<VtkCell> cell;
	const double* middles = cell->GetParametricCoords();
	const int size = grid::topology(shape).points;
	std::mt19937 random(31);
	std::uniform_real_distribution<double> moved(-0.12, 0.12);
	std::uniform_real_distribution<double> any(0.2, 1.0);
	for (int i = 0; i < 500; ++i)
	{
		std::vector<Vec3> points;
		Vec3 place(0.0);
		double all = 0.0;
		for (int p = 0; p < size; ++p)
		{
			const double x = middles[3 * p] + moved(random);
			const double y = middles[3 * p + 1] + moved(random);
			points.emplace_back(x, y, middles[3 * p + 2] + moved(random));
			cell->GetPoints()->SetPoint(p, &points.back().x);
			const double weight = any(random);
			place += weight * points.back();
			all += weight;
		}
		place /= all;
		int part = 0;
		double closest[3], coordinates[3], distance, weights[8];
		ASSERT_EQ(cell->EvaluatePosition(&place.x, closest, part, coordinates, distance, weights), 1);
		const auto ours = locate::shapeWeights(shape, points, place);
		ASSERT_TRUE(ours);
		for (int p = 0; p < size; ++p)
			EXPECT_NEAR(ours->weight[p], weights[p], 1e-4) << shapeName(shape); // VTK's iteration ends at 1e-3
	}
}

} // namespace

TEST(VtkInterpolation, AllShapes)
{
	compareShape<vtkTetra>(grid::CellShape::tetrahedron);
	compareShape<vtkPyramid>(grid::CellShape::pyramid);
	compareShape<vtkWedge>(grid::CellShape::wedge);
	compareShape<vtkHexahedron>(grid::CellShape::hexahedron);
}

} // namespace vp::test
