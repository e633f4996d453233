// The shape functions that a level and a tolerance refine by: they are 1 at their own node and 0 at the others, in the
// numbering of the tests, and agree with VTK's. What bounds a cell holds all of it.
#include "numbered_cells.h"

#include "refine/cell_boxes.h"
#include "refine/cell_kind.h"
#include "refine/near_cells.h"

#include <gtest/gtest.h>

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <random>

namespace vp::test
{

namespace
{

std::vector<NumberedCell> allKinds()
{
	std::vector<NumberedCell> kinds = linearCells();
	for (const NumberedCell& cell : quadraticCells())
		if (grid::isCurved(cell.type))
			kinds.push_back(cell);
	for (const Family family : {Family::lagrange, Family::bezier})
	{
		for (int degree = 1; degree <= 8; ++degree)
		{
			kinds.push_back(tetrahedronOf(family, degree));
			kinds.push_back(wedgeOf(family, degree, degree));
			kinds.push_back(hexahedronOf(family, {degree, degree, degree}));
		}
		kinds.push_back(hexahedronOf(family, {1, 2, 3}));
		kinds.push_back(hexahedronOf(family, {5, 2, 4}));
		kinds.push_back(wedgeOf(family, 1, 3));
		kinds.push_back(wedgeOf(family, 4, 2));
	}
	kinds.push_back(tetrahedronOf(Family::lagrange, 10));
	return kinds;
}

refine::CellKind kindOf(const NumberedCell& cell)
{
	return {cell.type, cell.nodes.size(), cell.degrees};
}

Vec3 placeIn(const NumberedCell& cell, std::mt19937& random)
{
	std::uniform_real_distribution<double> share(0.0, 1.0);
	for (;;)
	{
		Vec3 at(share(random), share(random), share(random));
		if (cell.shape == ParentShape::pyramid)
			return {at.x * (1.0 - at.z) + 0.5 * at.z, at.y * (1.0 - at.z) + 0.5 * at.z, at.z};
		const double sum = cell.shape == ParentShape::tetrahedron ? at.x + at.y + at.z
		                   : cell.shape == ParentShape::wedge     ? at.x + at.y
		                                                          : 0.0;
		if (sum <= 1.0)
			return at;
	}
}

std::vector<double> weightsOf(const refine::CellKind& kind, const Vec3& at)
{
	std::vector<double> weights(kind.nodes());
	kind.weighNodes(at, {}, weights.data());
	return weights;
}

std::vector<double> weightsOfVtk(const NumberedCell& cell, Vec3 at)
{
	vtkNew<vtkUnstructuredGrid> grid;
	vtkNew<vtkPoints> points;
	vtkNew<vtkIdList> ids;
	for (const Vec3& node : cell.nodes)
		ids->InsertNextId(points->InsertNextPoint(node.x, node.y, node.z));
	grid->SetPoints(points);
	grid->InsertNextCell(cell.type, ids);
	if (cell.degrees[0] > 0)
	{
		vtkNew<vtkDoubleArray> degrees;
		degrees->SetNumberOfComponents(3);
		degrees->InsertNextTuple3(cell.degrees[0], cell.degrees[1], cell.degrees[2]);
		grid->GetCellData()->SetHigherOrderDegrees(degrees);
	}
	std::vector<double> weights(std::max<std::size_t>(cell.nodes.size(), 27));
	grid->GetCell(0)->InterpolateFunctions(&at.x, weights.data());
	weights.resize(cell.nodes.size());
	return weights;
}

} // namespace

TEST(ShapeFunctions, AreOneAtTheirNode)
{
	for (const NumberedCell& cell : allKinds())
	{
		if (cell.is_bezier)
			continue;
		const refine::CellKind kind = kindOf(cell);
		for (std::size_t n = 0; n < cell.nodes.size(); ++n)
		{
			const std::vector<double> weights = weightsOf(kind, cell.nodes[n]);
			for (std::size_t other = 0; other < weights.size(); ++other)
				ASSERT_NEAR(weights[other], other == n ? 1.0 : 0.0, 1e-10) << cell << " " << n << " " << other;
		}
	}
}

TEST(ShapeFunctions, AgreeWithThoseOfVtk)
{
	std::mt19937 random(3);
	int compared = 0;
	for (const NumberedCell& cell : allKinds())
	{
		// VTK's functions of pyramids have other places and are not exact; those of Bezier cells take seconds.
		if (cell.shape == ParentShape::pyramid || (cell.is_bezier && cell.degree() > 4))
			continue;
		const refine::CellKind kind = kindOf(cell);
		for (int round = 0; round < 5; ++round)
		{
			const Vec3 at = placeIn(cell, random);
			const std::vector<double> ours = weightsOf(kind, at);
			const std::vector<double> theirs = weightsOfVtk(cell, at);
			for (std::size_t n = 0; n < ours.size(); ++n)
				ASSERT_NEAR(ours[n], theirs[n], 1e-12) << cell << " node " << n;
		}
		++compared;
	}
	EXPECT_GT(compared, 50);
}

// The 15 nodes of a tetrahedron and the 21 of a wedge, which no other test has.
TEST(ShapeFunctions, AgreeWithThoseOfVtkWhereTrianglesHaveMiddles)
{
	std::mt19937 random(4);
	NumberedCell tetrahedron = tetrahedronOf(Family::lagrange, 2);
	NumberedCell wedge = wedgeOf(Family::lagrange, 2, 2);
	tetrahedron.nodes.resize(15);
	wedge.nodes.resize(21);
	for (NumberedCell* cell : {&tetrahedron, &wedge})
	{
		cell->degrees = {};
		const refine::CellKind kind = kindOf(*cell);
		for (int round = 0; round < 5; ++round)
		{
			const Vec3 at = placeIn(*cell, random);
			const std::vector<double> ours = weightsOf(kind, at);
			const std::vector<double> theirs = weightsOfVtk(*cell, at);
			for (std::size_t n = 0; n < ours.size(); ++n)
				ASSERT_NEAR(ours[n], theirs[n], 1e-12) << *cell << " node " << n;
		}
	}
}

TEST(ShapeFunctions, OfPyramidsHoldQuadraticPolynomials)
{
	std::mt19937 random(5);
	const auto value = [](Vec3 p) { return 1.0 + p.x - 2.0 * p.y * p.z + 3.0 * p.x * p.x + p.z * p.z - p.x * p.y; };
	for (const NumberedCell& cell : quadraticCells())
	{
		if (cell.type != grid::kQuadraticPyramid)
			continue;
		for (int round = 0; round < 20; ++round)
		{
			const Vec3 at = placeIn(cell, random);
			const std::vector<double> weights = weightsOf(kindOf(cell), at);
			double sum = 0.0;
			for (std::size_t n = 0; n < weights.size(); ++n)
				sum += weights[n] * value(cell.nodes[n]);
			EXPECT_NEAR(sum, value(at), 1e-12);
		}
	}
}

// Cells with nodes anywhere, and weights where they are rational.
TEST(ShapeFunctions, BoundsHoldTheCell)
{
	std::mt19937 random(6);
	std::uniform_real_distribution<double> shift(-0.3, 0.3);
	std::uniform_real_distribution<double> weight(0.4, 2.0);
	double tightest = 0.0;
	for (const NumberedCell& cell : allKinds())
	{
		if (cell.degree() > 5)
			continue;
		grid::CurvedCells curved;
		std::vector<double> coordinates;
		std::vector<double> weights;
		std::vector<std::int32_t> ids;
		for (const Vec3& node : cell.nodes)
		{
			for (int axis = 0; axis < 3; ++axis)
				coordinates.push_back(node[axis] + shift(random));
			weights.push_back(weight(random));
			ids.push_back(static_cast<std::int32_t>(ids.size()));
		}
		curved.points = grid::Points(Array<double>(std::move(coordinates)));
		curved.cells.types = std::vector<std::uint8_t>{cell.type};
		curved.cells.offsets = std::vector<std::int64_t>{0, static_cast<std::int64_t>(ids.size())};
		curved.cells.connectivity = std::move(ids);
		curved.tolerance = 0.01;
		if (cell.degrees[0] > 0)
			curved.degrees = std::vector<std::int32_t>(cell.degrees.begin(), cell.degrees.end());
		if (cell.is_bezier)
			curved.weights = std::move(weights);
		const refine::CellKinds kinds(curved);
		refine::Sheets sheets;
		sheets.planes.emplace_back(Vec3(0.4, 0.3, 0.3), Vec3(0.3, 0.5, 0.8));
		refine::NearCells cells(curved, kinds, sheets, 1e-12, {});
		cells.add(std::vector<std::uint32_t>{0});
		ASSERT_EQ(cells.size(), 1u) << cell;
		const refine::CellBoxes boxes(curved, kinds);
		std::vector<double> scratch(refine::kMaxLattice);
		const auto at = [&](const Vec3& place)
		{
			Vec3 position;
			cells.evaluate(0, place, scratch.data(), &position.x);
			return position;
		};
		std::uniform_real_distribution<double> share(0.0, 1.0);
		for (int round = 0; round < 200; ++round)
		{
			std::array<Vec3, 4> corners;
			const double size = std::pow(0.5, round % 5);
			const Vec3 first = placeIn(cell, random);
			Vec3 lo = first;
			Vec3 hi = first;
			for (Vec3& corner : corners)
			{
				corner = first + size * (placeIn(cell, random) - first);
				lo = glm::min(lo, corner);
				hi = glm::max(hi, corner);
			}
			std::array<double, 4> b{share(random), share(random), share(random), share(random)};
			const double sum = b[0] + b[1] + b[2] + b[3];
			Vec3 place(0.0);
			Vec3 linear(0.0);
			for (std::size_t c = 0; c < 4; ++c)
			{
				place += b[c] / sum * corners[c];
				linear += b[c] / sum * at(corners[c]);
			}
			const double off = glm::length(at(place) - linear);
			const double bound = cells[0].bendWithin(lo, hi);
			ASSERT_LE(off, bound + 1e-12) << cell;
			tightest = std::max(tightest, bound > 0.0 ? off / bound : 0.0);
			// A plane that just touches the place finds the cell.
			refine::Sheets through;
			through.planes.emplace_back(at(place), Vec3(0.2, -0.5, 0.7));
			ASSERT_EQ(boxes.cellsNear(through).size(), 1u) << cell;
		}
	}
	EXPECT_GT(tightest, 0.2);
}

} // namespace vp::test
