// Times a moved plane: this program's cut (seeds, cells, mesh with shared vertices) beside VTK's cutters on the same
// grid in the same run, since only the ratio means something on a noisy machine. Planes are those of the sweep in
// `vprobe profile`.
//
//   build/release/bin/bench_cut --benchmark_filter=shell:256
//
// The first cut of vtkPlaneCutter, which builds its tree, is made before the clock runs.

#include "vtk_cuts.h"

#include "gpu/device.h"
#include "grid/demo.h"
#include "probe/path.h"
#include "probe/presets.h"
#include "slice/slicer.h"

#include <benchmark/benchmark.h>
#include <vtkDataSet.h>

#include <map>
#include <memory>
#include <string>

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

// The grid that was asked for last: several large ones do not fit into memory.
struct Grid
{
	std::string name;
	grid::BlockSet blocks;
	vtkSmartPointer<vtkDataSet> vtk;
};

Grid& gridNamed(const std::string& name)
{
	static Grid grid;
	if (grid.name != name)
	{
		grid = {}; // before the next one is made
		grid = {name, std::move(*grid::parseDemo(name)), nullptr};
	}
	return grid;
}

vtkDataSet* vtkNamed(const std::string& name)
{
	Grid& grid = gridNamed(name);
	if (!grid.vtk)
		grid.vtk = bench::asVtk(grid.blocks.blocks[0]);
	return grid.vtk;
}

void countCells(benchmark::State& state, std::size_t cells)
{
	state.counters["per_cell"] =
	    benchmark::Counter(static_cast<double>(cells), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void sweep(benchmark::State& state, slice::Slicer& slicer, slice::Finder finder)
{
	const std::vector<probe::Frame> planes = sweepOf(slicer.blocks().bounds());
	slice::SliceRequest request;
	request.probe = probe::single({});
	request.finder = finder;
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
	countCells(state, cells);
}

void cpuCut(benchmark::State& state, const std::string& name, slice::Finder finder)
{
	slice::Slicer slicer(gridNamed(name).blocks);
	sweep(state, slicer, finder);
}

void gpuCut(benchmark::State& state, const std::string& name)
{
	Result<std::unique_ptr<gpu::Device>> device = gpu::Device::create({});
	if (!device)
		return state.SkipWithError(device.error().message.c_str());
	Result<std::unique_ptr<slice::Slicer>> slicer =
	    slice::Slicer::onDevice(**device, gridNamed(name).blocks, {}, nullptr);
	if (!slicer)
		return state.SkipWithError(slicer.error().message.c_str());
	state.SetLabel((*device)->name());
	sweep(state, **slicer, slice::Finder::traversal);
}

void vtkCut(benchmark::State& state, const std::string& name, bench::VtkCut kind)
{
	const std::vector<probe::Frame> planes = sweepOf(gridNamed(name).blocks.bounds());
	bench::VtkCutter cutter(kind, vtkNamed(name));
	cutter.cut(planes.back());
	std::size_t k = 0;
	for (auto _ : state)
	{
		cutter.cut(planes[k]);
		k = (k + 1) % planes.size();
	}
}

template <class Function, class... Args>
void add(const std::string& name, const char* way, Function function, Args... args)
{
	benchmark::RegisterBenchmark((name + "/" + way).c_str(),
	                             [=](benchmark::State& state) { function(state, name, args...); })
	    ->Unit(benchmark::kMillisecond)
	    ->MinTime(1.0)
	    ->UseRealTime();
}

} // namespace

int main(int argc, char** argv)
{
	for (const char* name : {"shell:64", "shell:128", "shell:256", "shell:384", "hexes:128", "hexes:192", "tets:96",
	                         "tets:128", "blob:256", "blob:512"})
	{
		const bool is_image = std::string(name).starts_with("blob");
		add(name, "cpu", cpuCut, slice::Finder::automatic);
		add(name, "cpu, traversal", cpuCut, slice::Finder::traversal);
		add(name, "gpu", gpuCut);
		if (is_image)
			add(name, "vtkFlyingEdgesPlaneCutter", vtkCut, bench::VtkCut::flying_edges_cutter);
		else
			add(name, "vtkPlaneCutter", vtkCut, bench::VtkCut::plane_cutter);
		add(name, "vtkCutter", vtkCut, bench::VtkCut::cutter);
	}
	benchmark::Initialize(&argc, argv);
	if (benchmark::ReportUnrecognizedArguments(argc, argv))
		return 1;
	benchmark::RunSpecifiedBenchmarks();
	return 0;
}
