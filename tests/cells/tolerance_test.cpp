// Quadratic tetrahedra in files, read with a tolerance in place of a level.
#include "numbered_cells.h"

#include "grid/curved_cells.h"
#include "read/read.h"
#include "sample_files.h"
#include "sliced_sheet.h"

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

// Of the plane z = height.
double areaAt(double height, const grid::BlockSet& set)
{
	cut::Cutter cutter(set);
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(Vec3(0.5, 0.5, height), Vec3(0, 0, 1))};
	request.finder = find::Finder::automatic;
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

TEST(Tolerance, OtherCurvedCellsAreRefusedInOneLine)
{
	for (const NumberedCell& cell : quadraticCells())
	{
		const Result<grid::BlockSet> set = readWith(cubeOf(cell, 1), 0.01);
		if (cell.type == grid::kQuadraticTetra)
		{
			EXPECT_TRUE(set);
			continue;
		}
		ASSERT_FALSE(set) << cell;
		EXPECT_NE(set.error().message.find("a tolerance refines quadratic tetrahedra, and cell 0 is a "),
		          std::string::npos)
		    << set.error().message;
		EXPECT_NE(set.error().message.find("give a level"), std::string::npos) << set.error().message;
	}
	EXPECT_FALSE(readWith(cubeOf(tetrahedronOf(Family::lagrange, 3), 1), 0.01));
	EXPECT_FALSE(readWith(cubeOf(tetrahedronOf(Family::bezier, 2), 1), 0.01));
}

} // namespace vp::test
