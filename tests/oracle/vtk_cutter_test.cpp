#include "sliced_sheet.h"
#include "vtk_grids.h"

#include "grid/demo/demo.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCutter.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <set>

namespace vp::test
{

namespace
{

// The result of vtkCutter, measured by the same rule: fans about the means of the polygons' vertices.
struct VtkCut
{
	std::set<CellId> cells;
	std::size_t polygons = 0;
	std::size_t vertices = 0;
	double area = 0.0;
	double mean = 0.0;
};

VtkCut cutByVtk(vtkUnstructuredGrid* grid, const TestPlane& plane)
{
	const Vec3 normal = Side(plane).normal();
	vtkNew<vtkPlane> surface;
	surface->SetOrigin(plane.origin.x, plane.origin.y, plane.origin.z);
	surface->SetNormal(normal.x, normal.y, normal.z);
	vtkNew<vtkCutter> cutter;
	cutter->SetInputData(grid);
	cutter->SetCutFunction(surface);
	cutter->GenerateTrianglesOff();
	cutter->Update();
	vtkPolyData* output = cutter->GetOutput();

	VtkCut result;
	result.polygons = static_cast<std::size_t>(output->GetNumberOfPolys());
	result.vertices = static_cast<std::size_t>(output->GetNumberOfPoints());
	vtkDataArray* ids = output->GetCellData()->GetArray("cell");
	vtkDataArray* s = output->GetPointData()->GetArray("s");
	vtkNew<vtkIdList> corners;
	for (vtkIdType p = 0; p < output->GetNumberOfPolys(); ++p)
	{
		result.cells.insert(static_cast<CellId>(ids->GetTuple1(p)));
		output->GetPolys()->GetCellAtId(p, corners);
		const auto count = static_cast<std::size_t>(corners->GetNumberOfIds());
		std::vector<Vec3> at(count);
		std::vector<double> value(count);
		Vec3 center(0.0);
		double middle = 0.0;
		for (std::size_t i = 0; i < count; ++i)
		{
			output->GetPoint(corners->GetId(static_cast<vtkIdType>(i)), &at[i].x);
			value[i] = s->GetTuple1(corners->GetId(static_cast<vtkIdType>(i)));
			center += at[i] / static_cast<double>(count);
			middle += value[i] / static_cast<double>(count);
		}
		for (std::size_t i = 0; i < count; ++i)
		{
			const std::size_t next = (i + 1) % count;
			const double part = 0.5 * glm::length(glm::cross(at[i] - center, at[next] - center));
			result.area += part;
			result.mean += part * (value[i] + value[next] + middle) / 3.0;
		}
	}
	result.mean /= result.area;
	return result;
}

class VtkCutterTest : public testing::TestWithParam<std::pair<const char*, int>>
{
};

} // namespace

TEST_P(VtkCutterTest, FindsTheSame)
{
	const auto [name, n] = GetParam();
	const grid::BlockSet set = std::move(grid::makeDemo(name, n).value());
	const vtkSmartPointer<vtkUnstructuredGrid> peer = vtkCellsOf(set.blocks[0], set.blocks[0].fields[0]);
	cut::Cutter cutter(set);
	for (const TestPlane& plane : randomPlanes(set.bounds(), 25, 100))
	{
		const SlicedSheet sheet = cut(cutter, plane);
		if (sheet.mesh.polygons() == 0)
			continue;
		const VtkCut expected = cutByVtk(peer, plane);
		std::set<CellId> cells;
		for (const mesh::BlockCell& from : sheet.mesh.polygon_cells)
			cells.insert(from.cell);
		EXPECT_EQ(cells, expected.cells);
		EXPECT_EQ(sheet.mesh.positions.size(), expected.vertices);
		if (sheet.mesh.cells_twisted == 0)
		{
			EXPECT_EQ(sheet.mesh.polygons(), expected.polygons);
		}
		const measure::SheetMeasure measure =
		    measure::measure(set, sheet.mesh, grid::FieldChoice{"s", grid::Association::point, 0});
		EXPECT_NEAR(measure.area, expected.area, 1e-9 * expected.area);
		EXPECT_NEAR(measure.mean.value(), expected.mean, 1e-6);
	}
}

INSTANTIATE_TEST_SUITE_P(Demos, VtkCutterTest,
                         testing::Values(std::pair("shell", 18), std::pair("hexes", 15), std::pair("tets", 12),
                                         std::pair("blob", 16), std::pair("graded", 17), std::pair("mixed", 12),
                                         std::pair("layer", 14)),
                         [](const auto& info) { return info.param.first; });

} // namespace vp::test
