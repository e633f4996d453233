#include "sliced_sheet.h"
#include "test_grids.h"

#include "mesh/listed_mesh.h"
#include "mesh/mesh_values.h"

#include <gtest/gtest.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkExtractGrid.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStructuredGrid.h>
#include <vtkStructuredGridGeometryFilter.h>

#include <algorithm>
#include <tuple>

namespace vp::test
{

namespace
{

const char* const kGrids[] = {"blob", "graded", "shell", "left_handed", "warped_curvilinear"};

// With the field "linear", and each point's subscripts.
vtkSmartPointer<vtkStructuredGrid> vtkGridOf(const grid::Block& block)
{
	auto made = vtkSmartPointer<vtkStructuredGrid>::New();
	const grid::Lattice lattice = grid::latticeCellsOf(block)->lattice();
	const auto points = lattice.points();
	made->SetDimensions(static_cast<int>(points[0]), static_cast<int>(points[1]), static_cast<int>(points[2]));
	vtkNew<vtkPoints> places;
	places->SetDataTypeToDouble();
	vtkNew<vtkDoubleArray> linear;
	linear->SetName("linear");
	vtkNew<vtkDoubleArray> subscripts[3];
	for (PointId p = 0; p < lattice.pointCount(); ++p)
	{
		const Vec3 at = visitGrid(block, [&](const auto& grid) { return grid.point(p); });
		const std::size_t source = visitGrid(block, [&](const auto& grid) { return grid.sourcePoint(p); });
		places->InsertPoint(static_cast<vtkIdType>(source), at.x, at.y, at.z);
		linear->InsertValue(static_cast<vtkIdType>(source), linearAt(at));
		for (int axis = 0; axis < 3; ++axis)
			subscripts[axis]->InsertNextValue(lattice.pointIndex(p)[axis]);
	}
	made->SetPoints(places);
	made->GetPointData()->AddArray(linear);
	for (int axis = 0; axis < 3; ++axis)
	{
		subscripts[axis]->SetName(std::string(1, surface::axisName(axis)).c_str());
		made->GetPointData()->AddArray(subscripts[axis]);
	}
	return made;
}

using Place = std::tuple<double, double, double, double>; // and the value there

std::vector<Place> placesOf(vtkPolyData* data)
{
	std::vector<Place> places;
	vtkDataArray* linear = data->GetPointData()->GetArray("linear");
	for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
	{
		double at[3];
		data->GetPoint(p, at);
		places.emplace_back(at[0], at[1], at[2], linear->GetTuple1(p));
	}
	return places;
}

std::vector<Place> placesOf(const grid::BlockSet& set, const mesh::SheetMesh& mesh)
{
	std::vector<Place> places;
	const auto fields = grid::FieldChoice{"linear", grid::Association::point, 0}.inEach(set);
	for (std::size_t v = 0; v < mesh.positions.size(); ++v)
	{
		const Vec3& at = mesh.positions[v];
		places.emplace_back(at.x, at.y, at.z, mesh::vertexValue(set, mesh, v, fields, 0));
	}
	return places;
}

double distance(const Place& a, const Place& b)
{
	return std::abs(std::get<0>(a) - std::get<0>(b)) + std::abs(std::get<1>(a) - std::get<1>(b)) +
	       std::abs(std::get<2>(a) - std::get<2>(b)) + std::abs(std::get<3>(a) - std::get<3>(b));
}

// Each of ours is one of theirs, which are in single precision, and there are as many.
void expectSame(const std::vector<Place>& ours, const std::vector<Place>& theirs, double slack)
{
	ASSERT_EQ(ours.size(), theirs.size());
	for (const Place& place : ours)
	{
		const auto nearest = std::ranges::min_element(theirs, {}, [&](const Place& p) { return distance(p, place); });
		EXPECT_LE(distance(*nearest, place), slack);
	}
}

double areaOfQuads(vtkPolyData* data)
{
	double sum = 0.0;
	vtkNew<vtkIdList> corners;
	for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
	{
		data->GetCellPoints(c, corners);
		EXPECT_EQ(corners->GetNumberOfIds(), 4);
		Vec3 at[4];
		Vec3 center(0.0);
		for (int i = 0; i < 4; ++i)
		{
			data->GetPoint(corners->GetId(i), &at[i].x);
			center += at[i] / 4.0;
		}
		for (int i = 0; i < 4; ++i)
			sum += 0.5 * glm::length(glm::cross(at[i] - center, at[(i + 1) % 4] - center));
	}
	return sum;
}

} // namespace

TEST(GridSurfaceVtk, AtPointsItIsWhatExtractGridGives)
{
	for (const char* name : kGrids)
	{
		const grid::BlockSet set = setOf(gridNamed(name));
		const vtkSmartPointer<vtkStructuredGrid> peer = vtkGridOf(set.blocks[0]);
		const auto cells = grid::latticeCellsOf(set.blocks[0])->lattice().cells();
		for (int axis = 0; axis < 3; ++axis)
			for (int index = 0; index <= static_cast<int>(cells[axis]); ++index)
			{
				const surface::GridIndex at{axis, static_cast<double>(index)};
				int extent[6];
				peer->GetExtent(extent);
				extent[2 * axis] = extent[2 * axis + 1] = index;
				vtkNew<vtkExtractGrid> extract;
				extract->SetInputData(peer);
				extract->SetVOI(extent);
				vtkNew<vtkStructuredGridGeometryFilter> geometry;
				geometry->SetInputConnection(extract->GetOutputPort());
				geometry->Update();
				vtkPolyData* theirs = geometry->GetOutput();

				const mesh::SheetMesh ours = mesh::gridIndexMesh(set, at, find::gridIndexCells(set, at));
				SCOPED_TRACE(testing::Message() << name << " " << surface::nameOf(at));
				EXPECT_EQ(static_cast<vtkIdType>(ours.polygons()), theirs->GetNumberOfCells());
				expectSame(placesOf(set, ours), placesOf(theirs), 2e-6);
				EXPECT_NEAR(measure::measure(set, ours, {}).area, areaOfQuads(theirs), 1e-6 * areaOfQuads(theirs));
			}
	}
}

TEST(GridSurfaceVtk, BetweenPointsItIsTheContourOfTheirSubscript)
{
	for (const char* name : kGrids)
	{
		const grid::BlockSet set = setOf(gridNamed(name));
		const vtkSmartPointer<vtkStructuredGrid> peer = vtkGridOf(set.blocks[0]);
		const auto cells = grid::latticeCellsOf(set.blocks[0])->lattice().cells();
		for (int axis = 0; axis < 3; ++axis)
			for (const double index : {0.25, cells[axis] / 2 + 0.6, cells[axis] - 0.01})
			{
				const surface::GridIndex at{axis, index};
				peer->GetPointData()->SetActiveScalars(std::string(1, surface::axisName(axis)).c_str());
				vtkNew<vtkContourFilter> contour;
				contour->SetInputData(peer);
				contour->SetValue(0, index);
				contour->Update();
				const mesh::SheetMesh ours = mesh::gridIndexMesh(set, at, find::gridIndexCells(set, at));
				SCOPED_TRACE(testing::Message() << name << " " << surface::nameOf(at));
				expectSame(placesOf(set, ours), placesOf(contour->GetOutput()), 1e-5);
			}
	}
}

} // namespace vp::test
