// Curved cells in files, read with a tolerance in place of a level.
#include "numbered_cells.h"

#include "grid/curved/curved_cells.h"
#include "grid/measure.h"
#include "read/read.h"
#include "sample_files.h"
#include "sliced_sheet.h"
#include "tries.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vp::test
{

namespace
{

NumberedCell cellNamed(const std::string& name)
{
	for (const NumberedCell& cell : quadraticCells())
		if (cell.name == name)
			return cell;
	ADD_FAILURE() << "no cell " << name;
	return {};
}

Result<grid::BlockSet> readWith(const CubeMesh& mesh, double refine)
{
	const TemporaryFolder folder;
	const std::string path = folder / "cells.vtu";
	writeXml(mesh, path);
	read::ReadOptions options;
	options.refine = refine;
	return read::readInputs({path}, options, nullptr);
}

// Returns the area of the plane z = height.
double areaAt(double height, const grid::BlockSet& set)
{
	cut::Cutter cutter(set);
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(Vec3(0.5, 0.5, height), Vec3(0, 0, 1))};
	const cut::Cut cut = std::move(cutter.cut(request).value());
	return measure::measure(cut.blocksOf(set), cut.mesh(set, 0), {}).area;
}

// The cube with a waist: a section at z is a square of the side 1 - z (1 - z).
Vec3 waist(Vec3 p)
{
	const double side = 1.0 - p.z * (1.0 - p.z);
	return {0.5 + (p.x - 0.5) * side, 0.5 + (p.y - 0.5) * side, p.z};
}

double waistArea(double z)
{
	return std::pow(1.0 - z * (1.0 - z), 2);
}

} // namespace

TEST(Tolerance, FilesOfQuadraticTetrahedraAreRefinedWhereTheyAreCut)
{
	for (const NumberedCell& cell : {cellNamed("QuadraticTetra"), tetrahedronOf(Family::lagrange, 2)})
	{
		CubeMesh mesh = cubeOf(cell, 4);
		movePoints(mesh, waist);
		double before = 1.0;
		for (const double tolerance : {0.2, 0.01, 0.0005})
		{
			const Result<grid::BlockSet> set = readWith(mesh, tolerance);
			ASSERT_TRUE(set) << set.error().message;
			ASSERT_TRUE(set->blocks[0].curved);
			EXPECT_EQ(set->cellCount(), mesh.cells.size());
			double worst = 0.0;
			for (const double z : {0.13, 0.5, 0.61})
				worst = std::max(worst, std::abs(areaAt(z, *set) / waistArea(z) - 1.0));
			EXPECT_LT(worst, before) << cell << " " << tolerance;
			before = worst;
		}
		EXPECT_LT(before, 1e-4) << cell;
	}
}

TEST(Tolerance, LevelsAreStillLevels)
{
	const CubeMesh mesh = cubeOf(cellNamed("QuadraticTetra"), 2);
	for (const double level : {0.0, 1.0})
	{
		const Result<grid::BlockSet> set = readWith(mesh, level);
		ASSERT_TRUE(set) << set.error().message;
		EXPECT_FALSE(set->blocks[0].curved);
		EXPECT_EQ(set->cellCount(), mesh.cells.size() * (level > 0 ? 64 : 8));
	}
	const Result<grid::BlockSet> linear = readWith(cubeOf(linearCells()[0], 2), 0.01);
	ASSERT_TRUE(linear) << linear.error().message;
	EXPECT_FALSE(linear->blocks[0].curved);
}

namespace
{

// Returns cells of all shapes and orders.
std::vector<NumberedCell> curvedKinds(bool bezier)
{
	std::vector<NumberedCell> kinds;
	for (const NumberedCell& cell : quadraticCells())
		if (!bezier && grid::isCurved(cell.type))
			kinds.push_back(cell);
	const Family family = bezier ? Family::bezier : Family::lagrange;
	for (const int degree : {1, 2, 3, 4, 5, 8})
	{
		kinds.push_back(tetrahedronOf(family, degree));
		kinds.push_back(wedgeOf(family, degree, degree));
		kinds.push_back(hexahedronOf(family, {degree, degree, degree}));
	}
	kinds.push_back(hexahedronOf(family, {1, 2, 3}));
	kinds.push_back(hexahedronOf(family, {5, 2, 4}));
	kinds.push_back(wedgeOf(family, 1, 3));
	kinds.push_back(wedgeOf(family, 4, 2));
	// Other numberings, which the places of the nodes tell.
	kinds.push_back(wedgeOf(family, 4, 4, {.upward = true, .rings = true}));
	kinds.push_back(hexahedronOf(family, {3, 3, 3}, {.swaps_edges = true}));
	return kinds;
}

int degreeHeld(const NumberedCell& cell)
{
	if (cell.type == grid::kQuadraticLinearWedge)
		return 1;
	return cell.degrees[0] > 0 ? std::min({cell.degrees[0], cell.degrees[1], cell.degrees[2]}) : 2;
}

} // namespace

TEST(Tolerance, StraightCellsOfAllKindsAreExact)
{
	for (const bool bezier : {false, true})
		for (const NumberedCell& cell : curvedKinds(bezier))
		{
			CubeMesh mesh = cubeOf(cell, 1);
			const auto polynomial = [&](Vec3 p)
			{ return 1.0 + std::pow(0.3 * p.x - 0.45 * p.y + 0.6 * p.z + 0.2, bezier ? 1 : degreeHeld(cell)); };
			setValues(mesh, polynomial);
			const Result<grid::BlockSet> set = readWith(mesh, 0.02);
			ASSERT_TRUE(set) << cell << set.error().message;
			ASSERT_TRUE(set->blocks[0].curved) << cell;
			cut::Cutter cutter(*set);
			cut::CutRequest request;
			request.field = grid::FieldChoice{"f"};
			request.probe.sheets = {probe::makeSheet(Vec3(0.5, 0.5, 0.43), Vec3(0, 0, 1)),
			                        probe::makeSheet(Vec3(0.5, 0.5, 0.47), Vec3(0.3, -0.25, 1))};
			const cut::Cut cut = std::move(cutter.cut(request).value());
			const auto areaOf = [&](std::size_t sheet)
			{ return measure::measure(*cut.refined, cut.mesh(*set, sheet), {}).area; };
			EXPECT_NEAR(areaOf(0), 1.0, 1e-9) << cell;
			EXPECT_NEAR(areaOf(1), std::sqrt(1.0 + 0.3 * 0.3 + 0.25 * 0.25), 1e-9) << cell;
			const grid::Block& parts = cut.refined->blocks[0];
			const auto& grid = std::get<grid::UnstructuredGrid>(parts.grid);
			grid::CellFaces faces;
			for (CellId c = 0; c < grid.cellCount(); ++c)
				ASSERT_GT(grid::signedVolume(grid, c, faces) *
				              (cell.shape == ParentShape::wedge && cell.degrees[0] == 0 ? -1.0 : 1.0),
				          0.0)
				    << cell;
			for (PointId p = 0; p < grid.pointCount(); ++p)
				ASSERT_NEAR(parts.fields[0].value(grid.sourcePoint(p), 0), polynomial(grid.point(p)), 1e-11) << cell;
		}
}

// Beside parts of a high level. Also where cells bend both ways along an edge, so that its middle says nothing.
TEST(Tolerance, CurvedCellsOfAllKindsComeClose)
{
	Taken taken;
	const auto wave = [](Vec3 p) {
		return Vec3(p.x + 0.1 * std::sin(6.283185307 * p.y) * p.x, p.y + 0.15 * p.x * p.x * p.z, p.z - 0.1 * p.y * p.y);
	};
	for (const bool bezier : {false, true})
		for (const NumberedCell& cell : curvedKinds(bezier))
		{
			if (!taken.next())
				continue;
			CubeMesh mesh = cubeOf(cell, 2);
			movePoints(mesh, wave);
			const Result<grid::BlockSet> fine = readWith(mesh, cell.degree() > 2 ? 2 : 3);
			ASSERT_TRUE(fine) << cell << fine.error().message;
			for (const double tolerance : {0.03, 0.001})
			{
				const Result<grid::BlockSet> set = readWith(mesh, tolerance);
				ASSERT_TRUE(set) << cell << set.error().message;
				for (const double z : {0.13, 0.41})
					EXPECT_NEAR(areaAt(z, *set), areaAt(z, *fine), 0.4 * tolerance + 1e-3) << cell << " " << tolerance;
			}
		}
}

// A quarter of a ring, which takes weights to be round.
TEST(Tolerance, RationalCellsMakeArcs)
{
	CubeMesh mesh = cubeOf(hexahedronOf(Family::bezier, {2, 2, 2}), 1);
	for (Vec3& point : mesh.points)
	{
		const double radius = 1.0 + point.x;
		mesh.weights.push_back(point.y == 0.5 ? std::sqrt(0.5) : 1.0);
		point = Vec3(radius * (point.y < 0.75 ? 1.0 : 0.0), radius * (point.y > 0.25 ? 1.0 : 0.0), point.z);
	}
	double before = 1.0;
	for (const double tolerance : {0.1, 0.01, 0.001}) // 0.0001 would take more than 10 000 parts of the one cell
	{
		const Result<grid::BlockSet> set = readWith(mesh, tolerance);
		ASSERT_TRUE(set) << set.error().message;
		const double off = std::abs(areaAt(0.43, *set) - 0.75 * M_PI);
		EXPECT_LT(off, 3.0 * tolerance);
		EXPECT_LT(off, before);
		before = off;
	}
	mesh.weights[3] = 0.0;
	const Result<grid::BlockSet> set = readWith(mesh, 0.01);
	ASSERT_FALSE(set);
	EXPECT_NE(set.error().message.find("rational weight 0"), std::string::npos) << set.error().message;
}

TEST(Tolerance, OtherCellsAreRefusedInOneLine)
{
	const Result<grid::BlockSet> set = readWith(cubeOf(cellNamed("TriQuadraticPyramid"), 1), 0.01);
	ASSERT_FALSE(set);
	EXPECT_NE(set.error().message.find("which a tolerance does not refine"), std::string::npos) << set.error().message;
	EXPECT_NE(set.error().message.find("give a level"), std::string::npos) << set.error().message;
}

} // namespace vp::test
