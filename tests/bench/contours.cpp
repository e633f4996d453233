#include "contours.h"

#include "contour/box_contour.h"
#include "grids.h"

#include <vtkContourFilter.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

namespace vp::bench
{

namespace
{

constexpr double kPart = 1.0 / 10.0;

cut::CutRequest requestFor(const grid::BlockSet& blocks)
{
	const Vec3 size = blocks.bounds().size();
	cut::CutRequest request;
	request.field = grid::FieldChoice{blocks.blocks[0].fields[0].name, grid::Association::point, 0};
	// Beside the middle of the bounds, which in the shell is at its inner wall.
	const Vec3 origin = blocks.bounds().center() + Vec3(0.0, 0.12 * size.y, 0.05 * size.z);
	request.probe.sheets = {probe::makeSheet(origin, {0.0, 0.0, 1.0})};
	request.probe.sheets[0].window = probe::centeredWindow(kPart * size.x, kPart * size.y);
	return request;
}

double middleOf(const contour::BoxContourer& contourer)
{
	return 0.5 * (contourer.range()->first + contourer.range()->second);
}

double valueIn(const std::string& name)
{
	const grid::BlockSet& blocks = gridNamed(name);
	cut::Cutter cutter(blocks);
	const cut::Cut slice = std::move(cutter.cut(requestFor(blocks)).value());
	const mesh::SheetMesh mesh = slice.mesh(blocks, 0);
	return middleOf(contour::BoxContourer(cutter, slice.sheets[0], mesh, {}));
}

} // namespace

void boxContour(benchmark::State& state, const std::string& name, bool with_sheet)
{
	const grid::BlockSet& blocks = gridNamed(name);
	const double depth = kPart * blocks.bounds().size().z;
	const double value = valueIn(name);
	cut::Cutter cutter(blocks);
	const cut::CutRequest request = requestFor(blocks);
	cut::Cut slice = std::move(cutter.cut(request).value());
	mesh::SheetMesh mesh = slice.mesh(blocks, 0);
	std::size_t cells = 0;
	for (auto _ : state)
	{
		if (with_sheet)
		{
			slice = std::move(cutter.cut(request).value());
			mesh = slice.mesh(blocks, 0);
		}
		const contour::BoxContourer contourer(cutter, slice.sheets[0], mesh, depth);
		const contour::Contour contour = contourer.grow(value).value();
		cells = contour.cells;
		benchmark::DoNotOptimize(contour.mesh.positions.data());
	}
	state.counters["cells"] = static_cast<double>(cells);
}

void vtkContour(benchmark::State& state, const std::string& name)
{
	const double value = valueIn(name);
	vtkNew<vtkContourFilter> filter;
	filter->SetInputDataObject(vtkNamed(name));
	filter->SetValue(0, value);
	filter->ComputeNormalsOff();
	for (auto _ : state)
	{
		filter->Modified();
		filter->Update();
	}
	state.counters["triangles"] = static_cast<double>(filter->GetOutput()->GetNumberOfPolys());
}

} // namespace vp::bench
