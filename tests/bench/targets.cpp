#include "targets.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <vector>

namespace vp::bench
{

namespace
{

using Number = std::optional<double>;

struct Target
{
	std::string aim;
	std::string unit;
	double value;
	bool at_least; // else at most
	std::function<Number(const Figures&)> measure;
};

Number quotient(const Number& a, const Number& b)
{
	return a && b ? Number(*a / *b) : std::nullopt;
}

// How much faster one is than the other.
Target faster(std::string aim, double value, const std::string& ours, const std::string& theirs)
{
	return {std::move(aim), "times", value, true, [=](const Figures& f) { return quotient(f.ms(theirs), f.ms(ours)); }};
}

// The least time of some ways to cut a grid.
Number fastest(const Figures& f, const std::string& grid, std::initializer_list<const char*> ways)
{
	Number best;
	for (const char* way : ways)
		if (const Number ms = f.ms(grid + "/" + way); ms && (!best || *ms < *best))
			best = ms;
	return best;
}

// Against the fastest of VTK's cutters, from the same arrays.
Target firstCut(const std::string& grid)
{
	const auto measure = [=](const Figures& f)
	{
		return quotient(
		    fastest(f, grid,
		            {"first vtkPlaneCutter", "first vtkPlaneCutter without tree", "first vtk3DLinearGridPlaneCutter"}),
		    f.ms(grid + "/first cut"));
	};
	return {"first cut of " + grid + " against the fastest of VTK's", "times", 1.5, true, measure};
}

// Returns the target for a moved cut.
Target movedCut(const std::string& grid, double value)
{
	const auto measure = [=](const Figures& f)
	{
		return quotient(fastest(f, grid,
		                        {"vtkPlaneCutter", "vtkPlaneCutter without tree", "vtk3DLinearGridPlaneCutter",
		                         "vtkStructuredDataPlaneCutter", "vtkFlyingEdgesPlaneCutter"}),
		                f.ms(grid + "/cpu"));
	};
	return {grid + " against the fastest of VTK's", "times", value, true, measure};
}

Target againstPrototype(const std::string& grid)
{
	return {grid + " against the prototype", "times", 1.15, false,
	        [=](const Figures& f) { return quotient(f.ms(grid + "/cpu"), f.ms(grid + "/prototype")); }};
}

Target counted(std::string aim, std::string unit, double value, const std::string& benchmark,
               const std::string& counter)
{
	return {std::move(aim), std::move(unit), value, false,
	        [=](const Figures& f) { return f.counter(benchmark, counter); }};
}

// p of time ~ N^p, by least squares over the cells of three grids.
Number exponent(const Figures& figures)
{
	double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
	for (const int side : {128, 256, 384})
	{
		const Number ms = figures.ms("shell:" + std::to_string(side) + "/cpu");
		if (!ms)
			return std::nullopt;
		const double cells = 3.0 * std::log(side);
		n += 1.0;
		x += cells;
		y += std::log(*ms);
		xx += cells * cells;
		xy += cells * std::log(*ms);
	}
	return (n * xy - x * y) / (n * xx - x * x);
}

Number worstOrientation(const Figures& figures)
{
	double best = INFINITY;
	double worst = 0.0;
	for (const char* axes : {"", " jki", " kij"})
	{
		const Number ms = figures.ms(std::string("shell:256") + axes + "/cpu");
		if (!ms)
			return std::nullopt;
		best = std::min(best, *ms);
		worst = std::max(worst, *ms);
	}
	return worst / best;
}

// Time of a cut cell of long thin cells against that of cells that are nearly cubes.
Target thinCells(const std::string& layer)
{
	const auto measure = [=](const Figures& f)
	{ return quotient(f.counter(layer + "/cpu", "per_cell"), f.counter("hexes:128/cpu", "per_cell")); };
	return {"a cut cell of " + layer + " against one of hexes:128", "times", 1.5, false, measure};
}

std::vector<Target> targets()
{
	std::vector<Target> all;
	for (const char* grid : {"shell:128", "shell:256", "shell:384", "hexes:192", "hexes:256", "tets:128", "tets:184"})
		all.push_back(againstPrototype(grid));
	for (const char* grid : {"shell:256", "shell:384", "hexes:192", "hexes:256", "tets:128", "tets:184"})
		all.push_back(movedCut(grid, 12.0));
	all.push_back(movedCut("blob:256", 2.5));
	all.push_back(movedCut("blob:512", 7.0));
	const std::vector<Target> others{
	    {"p of time ~ N^p, shell:128 to shell:384", "", 0.68, false, exponent},
	    {"worst order of the shell's axes against the best", "times", 1.15, false, worstOrientation},
	    faster("first cut of shell:256, building included, against vtkPlaneCutter's", 5, "shell:256/first cut",
	           "shell:256/first vtkPlaneCutter"),
	    firstCut("hexes:192"),
	    firstCut("hexes:256"),
	    firstCut("tets:128"),
	    firstCut("tets:184"),
	    {"tets:184 built", "ms", 1200, false, [](const Figures& f) { return f.ms("tets:184/build"); }},
	    {"tets:184 built, cells shuffled", "ms", 5000, false,
	     [](const Figures& f) { return f.ms("tets:184/build shuffled"); }},
	    faster("window of 1/5 x 1/5 of the slice against all of it, shell:256", 12, "shell:256/window",
	           "shell:256/cpu"),
	    thinCells("layer:112"),
	    thinCells("layer:112 shuffled"),
	    faster("contour in a box of 1/10 each side, and its sheet, to vtkContourFilter", 50,
	           "shell:256/sheet and contour in a box", "shell:256/vtkContourFilter"),
	    counted("generations of a device's cut, shell:256", "", 24, "shell:256/gpu", "generations"),
	    faster("device's classifier, shell:256, one sheet, against vtkPlaneCutter", 4, "shell:256/gpu, one front",
	           "shell:256/vtkPlaneCutter"),
	    faster("device's classifier, shell:256, 8 vanes, against 8 of vtkPlaneCutter", 6, "shell:256/gpu, 8 vanes",
	           "shell:256/8 vanes vtkPlaneCutter"),
	    {"frames a second: 3 translucent vanes, shell:256, 1280x720", "", 30, true,
	     [](const Figures& f) { return quotient(Number(1000.0), f.counter("shell:256/frames", "frame_ms")); }},
	    faster("10 000 particles of 200 steps, shell:128, against vtkStreamTracer", 10, "shell:128/traces",
	           "shell:128/vtkStreamTracer"),
	    counted("bytes built besides a cell, shell:256", "", 4, "shell:256/memory", "extra_per_cell"),
	    counted("bytes built besides a cell, tets:128", "", 24, "tets:128/memory", "extra_per_cell"),
	    counted("bytes built besides a cell, hexes:192", "", 36, "hexes:192/memory", "extra_per_cell")};
	all.insert(all.end(), others.begin(), others.end());
	return all;
}

// Google Benchmark 1.8 tells errors in another way than 1.7.
template <class Run>
bool hasFailed(const Run& run)
{
	if constexpr (requires { run.error_occurred; })
		return run.error_occurred;
	else
		return run.skipped != 0;
}

} // namespace

void Figures::ReportRuns(const std::vector<Run>& runs)
{
	ConsoleReporter::ReportRuns(runs);
	for (const Run& run : runs)
	{
		if (hasFailed(run) || run.run_type != Run::RT_Iteration)
			continue;
		Figure figure{run.GetAdjustedRealTime(), {}};
		for (const auto& [name, counter] : run.counters)
			figure.counters[name] = counter.value;
		const std::string name = run.run_name.function_name;
		const auto known = figures_.find(name);
		if (known == figures_.end() || figure.ms < known->second.ms)
			figures_[name] = std::move(figure);
	}
}

Number Figures::ms(const std::string& name) const
{
	const auto figure = figures_.find(name);
	return figure == figures_.end() ? std::nullopt : Number(figure->second.ms);
}

Number Figures::counter(const std::string& name, const std::string& of) const
{
	const auto figure = figures_.find(name);
	if (figure == figures_.end() || !figure->second.counters.contains(of))
		return std::nullopt;
	return figure->second.counters.at(of);
}

void printTargets(const Figures& figures)
{
	bool has_title = false;
	for (const Target& target : targets())
	{
		const Number measured = target.measure(figures);
		if (!measured)
			continue;
		if (!has_title)
			std::printf("\n%-74s %10s %16s\n", "aim", "measured", "wanted");
		has_title = true;
		const bool met = target.at_least ? *measured >= target.value : *measured <= target.value;
		std::printf("%-74s %10.3g %8s %7.3g %-5s %s\n", target.aim.c_str(), *measured,
		            target.at_least ? "at least" : "at most", target.value, target.unit.c_str(), met ? "" : "missed");
	}
}

} // namespace vp::bench
