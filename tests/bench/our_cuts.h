#pragma once

#include "cut/cutter.h"
#include "probe/transform.h"

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace vp::bench
{

// As many planes, turned about the frame's up axis by equal angles within half a turn, the frame's own the first.
std::vector<probe::Frame> fanOf(const probe::Frame& frame, int planes);

// The number of cells that a plane of the sweep cuts, on the mean.
double cutCellsOfPlane(const std::string& name);

// How cells are found: in generations, as the paper has it, or in the fastest way that is possible.
enum class Search
{
	generations,
	fastest
};

// Moved planes: seeds, cells, the mesh, and the values of the grid's first array at its vertices.
void cpuCut(benchmark::State& state, const std::string& name, Search search);
// Counter "generations", on the mean. The polygons stay in device memory.
void gpuCut(benchmark::State& state, const std::string& name, Search search, int sheets);
// Within a window of 1/5 x 1/5 of the slice's extent about its center.
void windowCut(benchmark::State& state, const std::string& name);

// From the arrays as a file has them to the first mesh.
void firstCut(benchmark::State& state, const std::string& name);
// An unstructured grid from its cells: adjacency and order.
void buildGrid(benchmark::State& state, const std::string& name, bool shuffled);

// By `vprobe profile`, which is at `program`. Counter "extra_per_cell": bytes besides the grid as it was read.
void memory(benchmark::State& state, const std::string& program, const std::string& name);
// Counter "frame_ms": the median of a whole frame of three translucent vanes, 1280x720.
void frames(benchmark::State& state, const std::string& program, const std::string& name);

} // namespace vp::bench
