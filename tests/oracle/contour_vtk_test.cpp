#include "contour/box_contour.h"
#include "read/read.h"
#include "sliced_sheet.h"
#include "vtk_grids.h"

#include "grid/demo.h"

#include <gtest/gtest.h>
#include <vtkClipPolyData.h>
#include <vtkContourFilter.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
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

vtkSmartPointer<vtkPolyData> clipped(vtkSmartPointer<vtkPolyData> surface, const contour::ClipBox& box)
{
	for (const slice::ClipSide& side : box.sides())
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
		if (region.least <= 0.0 && region.most >= 0.0)
			area += region.area;
	return area;
}

struct Compared
{
	double ours = 0.0;
	double theirs = 0.0;
	std::size_t twisted = 0;
};

Compared compare(const grid::BlockSet& set, const std::string& array, const TestPlane& plane,
                 const probe::Window& window, double part)
{
	slice::Slicer slicer(set);
	SlicedSheet sheet = cut(slicer, plane, {}, slice::Finder::automatic, window);
	sheet.slice.field = slice::FieldChoice{array, grid::Association::point, 0};
	const contour::BoxContourer contourer(slicer, sheet.slice, sheet.mesh, std::nullopt);
	const auto [least, most] = contourer.range().value();
	const double value = least + part * (most - least);
	const contour::Contour contour = contourer.grow(value).value();

	const auto peer = vtkCellsOf(set.blocks[0], *sheet.slice.field->in(set.blocks[0]));
	vtkNew<vtkContourFilter> filter;
	filter->SetInputData(peer);
	filter->SetValue(0, value);
	filter->ComputeNormalsOff();
	filter->Update();
	return {slice::measure(set, contour.mesh, {}).area,
	        areaOnSheet(clipped(filter->GetOutput(), contourer.box()), contourer.box()), contour.mesh.cells_twisted};
}

void expectSame(const grid::BlockSet& set, const std::string& array, const TestPlane& plane,
                const probe::Window& window)
{
	for (const double part : {0.2, 0.5, 0.8})
	{
		const Compared areas = compare(set, array, plane, window, part);
		EXPECT_GT(areas.ours, 0.0);
		EXPECT_NEAR(areas.ours, areas.theirs, 1e-4 * areas.theirs) << part << ", twisted " << areas.twisted;
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
	expectSame(set, "s", {{0.6, 1.5, 0.3}, {0.3, 0.5, 0.81}}, probe::centredWindow(0.9, 0.6));
	expectSame(set, "s", {{-1.2, 1.0, -0.2}, {1.0, 0.2, 0.1}}, probe::Window{-0.1, 0.8, -0.4, 0.4});
}

TEST(ContourVtk, AreaOnTetrahedra)
{
	const grid::BlockSet set = std::move(grid::makeDemo("tets", 24).value());
	expectSame(set, "s", {{0.6, 1.5, 0.3}, {0.3, 0.5, 0.81}}, probe::centredWindow(0.9, 0.6));
}

TEST(ContourVtk, AreaOnPublishedTetrahedra)
{
	const grid::BlockSet set = published("unstructured/post_tets/post.vtk");
	if (set.blocks.empty())
		GTEST_SKIP() << "VPROBE_DATA names no folder of data sets";
	expectSame(set, "Pressure", {{1.0, 0.4, 0.5}, {0.3, 0.2, 1.0}}, probe::centredWindow(2.5, 2.0));
}

TEST(ContourVtk, AreaOnCarotid)
{
	const grid::BlockSet set = published("uniform/carotid/carotid.vtk");
	if (set.blocks.empty())
		GTEST_SKIP() << "VPROBE_DATA names no folder of data sets";
	expectSame(set, "scalars", {{137.0, 104.0, 23.0}, {0.1, 0.2, 1.0}}, probe::centredWindow(30.0, 25.0));
}

TEST(ContourVtk, AreaOnDiskOutRef)
{
	const grid::BlockSet set = published("unstructured/disk_out_ref/disk_out_ref.ex2");
	if (set.blocks.empty())
		GTEST_SKIP() << "VPROBE_DATA names no folder of data sets";
	expectSame(set, "Temp", {{0.1, 0.2, 0.3}, {0.1, 1.0, 0.2}}, probe::centredWindow(6.0, 5.0));
}

} // namespace vp::test
