// Times this program's cuts beside VTK's cutters on the same grid in the same run, since only the ratio means something
// on a noisy machine, and holds the ratios against what the program aims at. Planes are those of the sweep in
// `vprobe profile`; a cut is seeds, cells, the mesh with shared vertices, and the values of the grid's array there.
//
//   build/release/bin/bench_cut --benchmark_filter='shell:256|targets'
//
// For a moved plane, the first cut of vtkPlaneCutter, which builds its tree, is made before the clock runs.

#include "base/kept_memory.h"
#include "contours.h"
#include "grids.h"
#include "our_cuts.h"
#include "prototypes.h"
#include "targets.h"
#include "traces.h"
#include "vtk_cuts.h"

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

using namespace vp;

namespace
{

void vtkCut(benchmark::State& state, const std::string& name, bench::VtkCut kind, int sheets)
{
	const std::vector<probe::Frame> planes = bench::sweepOf(bench::gridNamed(name).bounds());
	bench::VtkCutter cutter(kind, bench::vtkNamed(name));
	cutter.cut(planes.back());
	std::size_t k = 0;
	for (auto _ : state)
	{
		for (const probe::Frame& plane : bench::fanOf(planes[k], sheets))
			cutter.cut(plane);
		k = (k + 1) % planes.size();
	}
}

void firstVtkCut(benchmark::State& state, const std::string& name, bench::VtkCut kind)
{
	const std::vector<probe::Frame> planes = bench::sweepOf(bench::listedNamed(name).bounds());
	vtkDataSet* grid = bench::vtkListedNamed(name);
	for (auto _ : state)
		bench::VtkCutter(kind, grid).cut(planes[planes.size() / 2]);
}

benchmark::internal::Benchmark* add(const std::string& name, const std::string& way,
                                    std::function<void(benchmark::State&)> function)
{
	return benchmark::RegisterBenchmark((name + "/" + way).c_str(), std::move(function))
	    ->Unit(benchmark::kMillisecond)
	    ->UseRealTime();
}

void addCuts(const std::string& name)
{
	using bench::VtkCut;
	constexpr double kSeconds = 1.0;
	const auto moved = [&](const char* way, auto function) { add(name, way, function)->MinTime(kSeconds); };
	moved("cpu", [=](auto& state) { bench::cpuCut(state, name, bench::Search::fastest); });
	moved("cpu, traversal", [=](auto& state) { bench::cpuCut(state, name, bench::Search::generations); });
	if (const auto prototype = bench::prototypeOf(name))
		benchmark::RegisterBenchmark((name + "/prototype").c_str(),
		                             [=](auto& state) { bench::prototypeCut(state, name, *prototype); })
		    ->Unit(benchmark::kMillisecond)
		    ->UseManualTime()
		    ->Iterations(1);
	moved("gpu", [=](auto& state) { bench::gpuCut(state, name, bench::Search::generations, 1); });
	moved("gpu, one front", [=](auto& state) { bench::gpuCut(state, name, bench::Search::fastest, 1); });
	moved("window", [=](auto& state) { bench::windowCut(state, name); });
	const auto rival = [&](const char* way, VtkCut kind)
	{ moved(way, [=](auto& state) { vtkCut(state, name, kind, 1); }); };
	if (name.starts_with("blob"))
		rival("vtkFlyingEdgesPlaneCutter", VtkCut::flying_edges_cutter);
	else
	{
		rival("vtkPlaneCutter", VtkCut::plane_cutter);
		rival("vtkPlaneCutter without tree", VtkCut::treeless_cutter);
	}
	if (name.starts_with("shell") && bench::kHasStructuredCutter)
		rival("vtkStructuredDataPlaneCutter", VtkCut::structured_cutter);
	if (name.starts_with("hexes") || name.starts_with("tets"))
		rival("vtk3DLinearGridPlaneCutter", VtkCut::linear_grid_cutter);
	rival("vtkCutter", VtkCut::cutter);
}

void addFirstCuts(const std::string& name)
{
	using bench::VtkCut;
	add(name, "first cut", [=](auto& state) { bench::firstCut(state, name); })->Iterations(5);
	if (!name.starts_with("shell"))
	{
		add(name, "first vtkPlaneCutter without tree",
		    [=](auto& state) { firstVtkCut(state, name, VtkCut::treeless_cutter); })
		    ->Iterations(5);
		add(name, "first vtk3DLinearGridPlaneCutter",
		    [=](auto& state) { firstVtkCut(state, name, VtkCut::linear_grid_cutter); })
		    ->Iterations(5);
	}
	add(name, "first vtkPlaneCutter", [=](auto& state) { firstVtkCut(state, name, VtkCut::plane_cutter); })
	    ->Iterations(1);
}

void addBuilding(const std::string& name)
{
	add(name, "build", [=](auto& state) { bench::buildGrid(state, name, false); })->Iterations(2);
	add(name, "build shuffled", [=](auto& state) { bench::buildGrid(state, name, true); })->Iterations(1);
}

void addContours(const std::string& name)
{
	for (const bool with_sheet : {false, true})
		add(name, with_sheet ? "sheet and contour in a box" : "contour in a box",
		    [=](auto& state) { bench::boxContour(state, name, with_sheet); })
		    ->MinTime(1.0);
	add(name, "vtkContourFilter", [=](auto& state) { bench::vtkContour(state, name); })->Iterations(2);
}

} // namespace

int main(int argc, char** argv)
{
	keepFreedMemory(); // as the program does
	const std::string program = std::filesystem::path(argv[0]).parent_path() / "vprobe";
	// Grid by grid, since one is kept at a time.
	for (const char* name : {"shell:64", "shell:128", "shell:256", "shell:384", "hexes:128", "hexes:192", "hexes:256",
	                         "tets:96", "tets:128", "tets:184", "blob:256", "blob:512"})
	{
		addCuts(name);
		const std::string grid = name;
		if (grid == "shell:256")
		{
			add(grid, "gpu, 8 vanes", [](auto& state) { bench::gpuCut(state, "shell:256", bench::Search::fastest, 8); })
			    ->MinTime(1.0);
			add(grid, "8 vanes vtkPlaneCutter",
			    [](auto& state) { vtkCut(state, "shell:256", bench::VtkCut::plane_cutter, 8); })
			    ->MinTime(1.0);
		}
		if (grid == "shell:128" || grid == "tets:96")
		{
			add(grid, "traces", [=](auto& state) { bench::ourTraces(state, grid); })
			    ->MeasureProcessCPUTime() // CPU time of all threads
			    ->MinTime(1.0);
			add(grid, "vtkStreamTracer", [=](auto& state) { bench::vtkTraces(state, grid); })->Iterations(1);
		}
		if (grid == "shell:256")
			addContours(grid);
		if (grid == "hexes:256" || grid == "tets:184")
			addBuilding(grid);
		if (grid == "shell:256" || grid == "hexes:192" || grid == "hexes:256" || grid == "tets:128" ||
		    grid == "tets:184")
			addFirstCuts(grid);
	}
	for (const char* name : {"shell:256 jki", "shell:256 kij", "layer:112", "layer:112 shuffled"})
		add(name, "cpu", [=](auto& state) { bench::cpuCut(state, name, bench::Search::fastest); })->MinTime(1.0);
	for (const char* name : {"shell:256", "tets:128", "hexes:192"})
		add(name, "memory", [=](auto& state) { bench::memory(state, program, name); })->Iterations(1);
	add("shell:256", "frames", [=](auto& state) { bench::frames(state, program, "shell:256"); })->Iterations(1);

	benchmark::Initialize(&argc, argv);
	if (benchmark::ReportUnrecognizedArguments(argc, argv))
		return 1;
	bench::Figures figures;
	benchmark::RunSpecifiedBenchmarks(&figures);
	bench::printTargets(figures);
	return 0;
}
