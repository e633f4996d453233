// A side that is not flat, where a cell meets several smaller ones.
#include "closed_sheet.h"

#include "read/read.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vp::test
{

namespace
{

enum class Cells
{
	both,
	hexahedron,
	tetrahedra
};

// A side of a hexahedron is not flat, and two of six tetrahedra share it.
grid::BlockSet warpedSide(Cells cells = Cells::both)
{
	vtkNew<vtkPoints> points;
	points->SetDataType(VTK_DOUBLE);
	for (const double layer : {0.0, 1.0, 2.0})
		for (int corner = 0; corner < 4; ++corner)
			points->InsertNextPoint(corner == 1 || corner == 2, corner / 2,
			                        layer == 1.0 ? 1.0 + (corner % 2 ? -0.2 : 0.2) : layer);
	vtkNew<vtkUnstructuredGrid> grid;
	grid->SetPoints(points);
	grid->Allocate(7);
	constexpr vtkIdType kBelow[] = {0, 1, 2, 3, 4, 5, 6, 7};
	if (cells != Cells::tetrahedra)
		grid->InsertNextCell(VTK_HEXAHEDRON, 8, kBelow);
	constexpr vtkIdType kAbove[][4] = {{4, 5, 6, 10},  {4, 9, 5, 10}, {4, 6, 7, 10},
	                                   {4, 7, 11, 10}, {4, 8, 9, 10}, {4, 11, 8, 10}};
	if (cells != Cells::hexahedron)
		for (const auto& tetrahedron : kAbove)
			grid->InsertNextCell(VTK_TETRA, 4, tetrahedron);
	const TemporaryFolder folder;
	writeGrid(grid, folder / "warped.vtu");
	return std::move(*read::readInputs({folder / "warped.vtu"}, {}, nullptr));
}

} // namespace

// The tetrahedra have a vertex on the diagonal, and the hexahedron's polygon has none. Its area stays what it is, and
// the sheet is one piece all the same.
TEST(Hanging, AWarpedSideMeetsTwoTriangles)
{
	std::vector<grid::BlockSet> sets;
	for (const Cells cells : {Cells::both, Cells::hexahedron, Cells::tetrahedra})
		sets.push_back(warpedSide(cells));
	Box box;
	box.include(Vec3(0.0));
	box.include(Vec3(1.0, 1.0, 2.0));
	int overlapping = 0;
	for (const TestPlane& plane : {TestPlane{{0.5, 0.5, 1.0}, {0.7, 0.2, 1}}, TestPlane{{0.5, 0.5, 1.0}, {0.1, 0.9, 1}},
	                               TestPlane{{0.5, 0.5, 1.0}, {-0.6, 0.5, 1}}})
		for (const mesh::Hanging hanging : {mesh::Hanging::keep, mesh::Hanging::interpolate})
		{
			cut::CutRequest request;
			request.in_generations = true;
			request.hanging = hanging;
			std::vector<Whole> wholes;
			for (const grid::BlockSet& set : sets)
			{
				cut::Cutter cutter(set);
				wholes.push_back(cutWhole(cutter, plane, request));
			}
			EXPECT_NEAR(wholes[0].figures.area, wholes[1].figures.area + wholes[2].figures.area, 1e-14);
			// On a plane that meets the diagonal in the line of the hexahedron's polygon, nothing overlaps.
			const bool overlaps = std::abs(wholes[0].figures.area - glm::length(plane.normal)) > 1e-4;
			overlapping += overlaps;
			EXPECT_EQ(wholes[0].figures.components, 1u);
			EXPECT_EQ(wholes[0].mesh.seam_pairs.empty(), !overlaps);
			expectClosed(wholes[0].mesh, box);
		}
	EXPECT_EQ(overlapping, 4);
}

// The hexahedron and the tetrahedra may join the four vertices of a side that is cut twice in different pairs. Each
// polygon is that of its cell all the same.
TEST(Hanging, AWarpedSideThatIsCutTwiceLosesNothing)
{
	std::vector<grid::BlockSet> sets;
	for (const Cells cells : {Cells::both, Cells::hexahedron, Cells::tetrahedra})
		sets.push_back(warpedSide(cells));
	for (const TestPlane& plane : {TestPlane{{0.5, 0.5, 1.03}, {0.1, 0.05, 1}}, TestPlane{{0.5, 0.5, 1.0}, {0, 0, 1}},
	                               TestPlane{{0.5, 0.5, 0.95}, {-0.1, 0.02, 1}}})
	{
		std::vector<double> areas;
		std::vector<std::size_t> polygons;
		for (const grid::BlockSet& set : sets)
		{
			cut::Cutter cutter(set);
			const Whole whole = cutWhole(cutter, plane);
			areas.push_back(whole.figures.area);
			polygons.push_back(whole.mesh.polygons());
		}
		EXPECT_GT(std::min(areas[1], areas[2]), 0.1);
		EXPECT_NEAR(areas[0], areas[1] + areas[2], 1e-12);
		EXPECT_EQ(polygons[0], polygons[1] + polygons[2]);
	}
}

} // namespace vp::test
