#include "contour/box_contour.h"
#include "read/read.h"
#include "sliced_sheet.h"
#include "vtk_grids.h"

#include "grid/demo/demo.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkClipPolyData.h>
#include <vtkContourFilter.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkUnstructuredGrid.h>

#include <cstdlib>
#include <filesystem>
#include <map>

namespace vp::test
{

namespace
{

// Returns the surface of polygons as triangles about the mean of the corners.
vtkSmartPointer<vtkPolyData> inFans(vtkPolyData* surface)
{
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	points->DeepCopy(surface->GetPoints());
	vtkNew<vtkCellArray> triangles;
	vtkNew<vtkIdList> corners;
	for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
	{
		surface->GetCellPoints(c, corners);
		const vtkIdType count = corners->GetNumberOfIds();
		Vec3 mean(0.0);
		for (vtkIdType i = 0; i < count; ++i)
		{
			Vec3 at;
			surface->GetPoint(corners->GetId(i), &at.x);
			mean += at / static_cast<double>(count);
		}
		const vtkIdType center = count == 3 ? -1 : points->InsertNextPoint(mean.x, mean.y, mean.z);
		if (count == 3)
			triangles->InsertNextCell(corners);
		for (vtkIdType i = 0; count > 3 && i < count; ++i)
		{
			const vtkIdType triangle[] = {corners->GetId(i), corners->GetId((i + 1) % count), center};
			triangles->InsertNextCell(3, triangle);
		}
	}
	auto made = vtkSmartPointer<vtkPolyData>::New();
	made->SetPoints(points);
	made->SetPolys(triangles);
	return made;
}

vtkSmartPointer<vtkPolyData> clipped(vtkSmartPointer<vtkPolyData> surface, const contour::ClipBox& box)
{
	for (const mesh::ClipSide& side : box.sides())
	{
		vtkNew<vtkPlane> plane;
		const Vec3 on = box.frame().origin + side.least * side.axis;
		plane->SetOrigin(on.x, on.y, on.z);
		plane->SetNormal(side.axis.x, side.axis.y, side.axis.z);
		vtkNew<vtkClipPolyData> clip;
		clip->SetInputData(surface);
		clip->SetClipFunction(plane);
		clip->Update();
		surface = clip->GetOutput();
	}
	return surface;
}

// Per region of connected triangles: their area, and how far they reach along the sheet's normal.
struct Region
{
	double area = 0.0;
	double least = 1e300;
	double most = -1e300;
};

double areaOnSheet(vtkPolyData* surface, const contour::ClipBox& box)
{
	vtkNew<vtkPolyDataConnectivityFilter> connect;
	connect->SetInputData(surface);
	connect->SetExtractionModeToAllRegions();
	connect->ColorRegionsOn();
	connect->Update();
	vtkPolyData* colored = connect->GetOutput();
	vtkDataArray* regions_of = colored->GetPointData()->GetArray("RegionId");
	std::map<int, Region> regions;
	vtkNew<vtkIdList> corners;
	for (vtkIdType c = 0; c < colored->GetNumberOfCells(); ++c)
	{
		colored->GetCellPoints(c, corners);
		Region& region = regions[static_cast<int>(regions_of->GetTuple1(corners->GetId(0)))];
		std::vector<Vec3> at(static_cast<std::size_t>(corners->GetNumberOfIds()));
		for (std::size_t i = 0; i < at.size(); ++i)
		{
			colored->GetPoint(corners->GetId(static_cast<vtkIdType>(i)), &at[i].x);
			const double height = box.inBox(at[i]).z;
			region.least = std::min(region.least, height);
			region.most = std::max(region.most, height);
		}
		for (std::size_t i = 1; i + 1 < at.size(); ++i)
			region.area += 0.5 * glm::length(glm::cross(at[i] - at[0], at[i + 1] - at[0]));
	}
	double area = 0.0;
	for (const auto& [id, region] : regions)
	{
		if (region.least <= 0.0 && region.most >= 0.0)
			area += region.area;
	}
	return area;
}

// The sheet across `plane`, in a window about its origin; contours of values at these parts of the range it shows.
void expectSame(const grid::BlockSet& set, const std::string& array, const TestPlane& plane, double width,
                double height, std::initializer_list<double> parts = {0.2, 0.5, 0.8})
{
	cut::Cutter cutter(set);
	SlicedSheet sheet = cut(cutter, plane, {}, Search::fastest, std::optional(probe::centeredWindow(width, height)));
	sheet.slice.field = grid::FieldChoice{array, grid::Association::point, 0};
	const contour::BoxContourer contourer(cutter, sheet.slice, sheet.mesh, std::nullopt);
	const auto [least, most] = contourer.range().value();
	const auto peer = vtkCellsOf(set.blocks[0], *sheet.slice.field->in(set.blocks[0]));
	vtkNew<vtkContourFilter> filter;
	filter->SetInputData(peer);
	filter->ComputeNormalsOff();
	filter->GenerateTrianglesOff();
	for (const double part : parts)
	{
		const double value = least + part * (most - least);
		const contour::Contour contour = contourer.grow(value).value();
		filter->SetValue(0, value);
		filter->Update();
		const double ours = measure::measure(set, contour.mesh, {}).area;
		const double theirs = areaOnSheet(clipped(inFans(filter->GetOutput()), contourer.box()), contourer.box());
		EXPECT_GT(ours, 0.0);
		// If a cell's surface is ambiguous, the two programs have different rules.
		EXPECT_EQ(contour.mesh.cells_twisted, 0u) << part;
		EXPECT_NEAR(ours, theirs, 1e-4 * theirs) << part;
	}
}

grid::BlockSet published(const std::string& name)
{
	const char* data = std::getenv("VPROBE_DATA");
	const std::string file = (std::filesystem::path(data ? data : "") / name).string();
	if (!data || !std::filesystem::exists(file))
		return {};
	return std::move(read::readInputs({file}, {}, nullptr).value());
}

} // namespace

TEST(ContourVtk, AreaOnTheShell)
{
	const grid::BlockSet set = std::move(grid::makeDemo("shell", 64).value());
	expectSame(set, "s", {{0.6, 1.5, 0.3}, {0.3, 0.5, 0.81}}, 0.9, 0.6);
	expectSame(set, "s", {{-1.2, 1.0, -0.2}, {1.0, 0.2, 0.1}}, 0.9, 0.8);
}

TEST(ContourVtk, AreaOnTetrahedra)
{
	const grid::BlockSet set = std::move(grid::makeDemo("tets", 24).value());
	expectSame(set, "s", {{0.6, 1.5, 0.3}, {0.3, 0.5, 0.81}}, 0.9, 0.6);
}

// Its cells are coarse: where the box cuts polygons that bend, as it does at lower values, their parts differ by more.
TEST(ContourVtk, AreaOnDiskOutRef)
{
	const grid::BlockSet set = published("unstructured/disk_out_ref/disk_out_ref.ex2");
	if (set.blocks.empty())
		GTEST_SKIP() << "VPROBE_DATA names no folder of data sets";
	expectSame(set, "Temp", {{0.1, 0.2, 0.3}, {0.1, 1.0, 0.2}}, 6.0, 5.0, {0.5, 0.65, 0.8});
}

// At higher values pieces meet at an inner wall, of which VTK makes one by its points.
TEST(ContourVtk, AreaOnPublishedTetrahedra)
{
	const grid::BlockSet set = published("unstructured/post_tets/post.vtk");
	if (set.blocks.empty())
		GTEST_SKIP() << "VPROBE_DATA names no folder of data sets";
	expectSame(set, "Pressure", {{1.0, 0.4, 0.5}, {0.3, 0.2, 1.0}}, 2.5, 2.0, {0.2, 0.35, 0.5});
}

} // namespace vp::test
