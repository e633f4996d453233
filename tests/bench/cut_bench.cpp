// Times a moved plane: this program's cut (seeds, traversal, mesh) beside vtkCutter on the same grid in the same run,
// since only the ratio means something on a noisy machine. Planes are those of the sweep in `vprobe profile`.
//
//   build/release/bin/bench_cut --benchmark_filter=shell

#include "gpu/device.h"
#include "grid/demo.h"
#include "probe/path.h"
#include "probe/presets.h"
#include "slice/slicer.h"

#include <benchmark/benchmark.h>

#include <vtkCutter.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStructuredGrid.h>

#include <map>

using namespace vp;

namespace
{

// The planes that `vprobe profile` sweeps through.
std::vector<probe::Frame> sweepOf(const Box& bounds)
{
	probe::Path path;
	path.kind = probe::PathKind::profile;
	return probe::poses(path, {}, bounds, probe::kProfilePlanes);
}

const grid::BlockSet& shell(int n)
{
	static std::map<int, grid::BlockSet> made;
	const auto [at, is_new] = made.try_emplace(n);
	if (is_new)
		at->second = std::move(*grid::makeDemo("shell", n));
	return at->second;
}

void sweep(benchmark::State& state, slice::Slicer& slicer, const Box& bounds)
{
	const std::vector<probe::Frame> planes = sweepOf(bounds);
	slice::SliceRequest request;
	request.probe = probe::single({});
	request.finder = slice::Finder::automatic;
	std::size_t k = 0;
	std::size_t cells = 0;
	for (auto _ : state)
	{
		request.probe.frame = planes[k];
		Result<slice::Slice> slice = slicer.cut(request);
		const slice::SheetMesh mesh = slice->mesh(slicer.blocks(), 0);
		benchmark::DoNotOptimize(mesh.positions.data());
		cells += mesh.polygons();
		k = (k + 1) % planes.size();
	}
	state.counters["per_cell"] =
	    benchmark::Counter(static_cast<double>(cells), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void cpuCut(benchmark::State& state)
{
	const grid::BlockSet& blocks = shell(static_cast<int>(state.range(0)));
	slice::Slicer slicer(blocks);
	sweep(state, slicer, blocks.bounds());
}

void gpuCut(benchmark::State& state)
{
	Result<std::unique_ptr<gpu::Device>> device = gpu::Device::create({});
	if (!device)
		return state.SkipWithError(device.error().message.c_str());
	const grid::BlockSet& blocks = shell(static_cast<int>(state.range(0)));
	Result<std::unique_ptr<slice::Slicer>> slicer = slice::Slicer::onDevice(**device, blocks, {}, nullptr);
	if (!slicer)
		return state.SkipWithError(slicer.error().message.c_str());
	state.SetLabel((*device)->name());
	sweep(state, **slicer, blocks.bounds());
}

void vtkCut(benchmark::State& state)
{
	const int n = static_cast<int>(state.range(0));
	const grid::BlockSet& blocks = shell(n);
	const auto& grid = std::get<grid::CurvilinearGrid>(blocks.blocks[0].grid);
	vtkNew<vtkPoints> points;
	points->SetDataTypeToFloat();
	points->SetNumberOfPoints(static_cast<vtkIdType>(grid.pointCount()));
	vtkNew<vtkFloatArray> scalars;
	scalars->SetName("s");
	scalars->SetNumberOfTuples(points->GetNumberOfPoints());
	for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
	{
		const Vec3 at = grid.point(static_cast<PointId>(p));
		points->SetPoint(p, at.x, at.y, at.z);
		scalars->SetValue(p, static_cast<float>(blocks.blocks[0].fields[0].value(p, 0)));
	}
	vtkNew<vtkStructuredGrid> input;
	input->SetDimensions(n + 1, n + 1, n + 1);
	input->SetPoints(points);
	input->GetPointData()->SetScalars(scalars);

	vtkNew<vtkPlane> plane;
	vtkNew<vtkCutter> cutter;
	cutter->SetInputData(input);
	cutter->SetCutFunction(plane);
	cutter->GenerateTrianglesOff();
	const std::vector<probe::Frame> planes = sweepOf(blocks.bounds());
	std::size_t k = 0;
	for (auto _ : state)
	{
		plane->SetOrigin(planes[k].origin.x, planes[k].origin.y, planes[k].origin.z);
		plane->SetNormal(planes[k].normal.x, planes[k].normal.y, planes[k].normal.z);
		cutter->Update();
		benchmark::DoNotOptimize(cutter->GetOutput()->GetNumberOfPoints());
		k = (k + 1) % planes.size();
	}
}

} // namespace

BENCHMARK(cpuCut)
    ->Name("shell/cpu")
    ->Arg(64)
    ->Arg(128)
    ->Arg(256)
    ->Unit(benchmark::kMillisecond)
    ->MinTime(1.0)
    ->UseRealTime();
BENCHMARK(gpuCut)
    ->Name("shell/gpu")
    ->Arg(64)
    ->Arg(128)
    ->Arg(256)
    ->Unit(benchmark::kMillisecond)
    ->MinTime(1.0)
    ->UseRealTime();
BENCHMARK(vtkCut)
    ->Name("shell/vtkCutter")
    ->Arg(64)
    ->Arg(128)
    ->Arg(256)
    ->Unit(benchmark::kMillisecond)
    ->MinTime(1.0)
    ->UseRealTime();

BENCHMARK_MAIN();
