#pragma once

#include "base/ids.h"
#include "base/raw_vector.h"
#include "base/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::vectors
{

// The reason why a trace ends.
enum class TraceEnd : std::uint8_t
{
	steps,       // all its steps are done
	left_grid,   // the next place lies outside the grid, or in a hidden cell
	zero_vector, // nothing moves there
	no_vector,   // NaN or infinite, or the block lacks the array; for path lines also beyond the stored times
	gave_up      // a step took more substeps than a step may: its dt reaches over thousands of cells
};

// Their names in files and figures.
constexpr std::array<const char*, 5> kTraceEndWords{"steps", "left_grid", "zero_vector", "no_vector", "gave_up"};

constexpr const char* traceEndWord(TraceEnd end)
{
	return kTraceEndWords[static_cast<std::size_t>(end)];
}

// Paths of particles that follow a vector field, each from its earliest point to its latest.
struct Traces
{
	std::vector<std::uint32_t> starts{0}; // traces + 1 offsets into the points
	std::vector<std::uint32_t> seeds;     // per trace: its place in the lattice of launches
	std::vector<std::uint32_t> launches;  // per trace: the number of its launch among all points
	std::vector<TraceEnd> begins;         // per trace: why it begins there
	std::vector<TraceEnd> ends;           // per trace: why it ends there

	// Per point of all traces.
	RawVector<Vec3> points;
	RawVector<double> times;         // time since the launch; negative before it
	RawVector<Vec3> vectors;         // the whole vector there
	RawVector<std::uint32_t> blocks; // block of the cell that contains it
	RawVector<CellId> cells;

	std::size_t count() const { return starts.size() - 1; }
	std::size_t first(std::size_t trace) const { return starts[trace]; }
	std::size_t size(std::size_t trace) const { return starts[trace + 1] - starts[trace]; }
	std::span<const Vec3> path(std::size_t trace) const { return std::span(points).subspan(first(trace), size(trace)); }
};

} // namespace vp::vectors
