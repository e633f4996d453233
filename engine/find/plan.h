#pragma once

#include "base/result.h"
#include "find/listed.h"
#include "grid/block.h"
#include "probe/sheet.h"
#include "seed/seeds.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vp::find
{

/// How to find the cut cells of a sheet in a block. All strategies find the same cells.
enum class Strategy
{
	rows,        // straight axes: the plane's equation gives each row's cells, without a search (rows.h)
	spans,       // curvilinear grids: a flood over runs of cells (spans.h)
	cells,       // unstructured grids: a flood over cells (cells.h)
	generations, // any grid: breadth first from the seeds, each generation classified as a whole (generations.h)
	listed,      // a grid index or a patch: its cells are known by their subscripts or faces (listed.h)
	scan         // unstructured grids: every cell is looked at once, and no neighbors are needed (scan.h)
};

/// Who computes the case codes of the cells. Polyhedra are always classified by the CPU.
enum class Processor
{
	cpu,
	gpu
};

/// Returns the strategy with this name, or nothing.
std::optional<Strategy> strategyNamed(std::string_view name);
const char* nameOf(Strategy strategy);
const char* nameOf(Processor classifier);

/// The facts about a request that a plan depends on.
struct PlanRequest
{
	std::span<const probe::Sheet> sheets;   // the plan does not keep it
	const ListedSurface* surface = nullptr; // replaces the sheets, or null
	bool has_threshold = false;             // range of values: the search does not continue past cells outside
	seed::SeedMode seed_mode = seed::SeedMode::boundary;
	bool looks_for_hot_spot = false; // the cut must know whether the hot spot lies in the grid
	bool another_follows = false;    // more cuts will follow, so it pays to build neighbors
	bool in_generations = false;     // each cell must be met in its generation, so no other strategy serves
	// A device was asked for by name. It classifies a generation at a time in place of a search on the CPU. Without
	// this the CPU searches, and a device classifies what it found as one wide front.
	bool device_first = false;
	std::optional<Strategy> strategy; // for all sheets and blocks; an error if it is impossible
};

/// How one sheet is cut in one block.
struct BlockPlan
{
	Strategy strategy = Strategy::generations;
	Processor classifier = Processor::cpu;
	const char* why_strategy = "";
	const char* why_classifier = ""; // empty if there is nothing to say

	/// Returns a few words: why this strategy, and why no device if one is left out.
	std::string reason() const;
};

/// How every sheet is cut in every block: sheets[s][b]. A surface that replaces the sheets counts as one sheet.
struct CutPlan
{
	std::vector<std::vector<BlockPlan>> sheets;

	/// If true, call grid::buildNeighbors() before carrying out the plan.
	bool needs_neighbors = false;
};

/// The facts about a classifying device that a plan depends on.
struct DeviceProfile
{
	std::vector<bool> holds; // per block: true if it is in device memory; false if it exceeds a limit of the device
};

/// Plans a cut. A pure function that looks at no cell: its time depends on the number of sheets and blocks, and on the
/// axes of rectilinear blocks. The blocks say what has been built (grid::hasNeighbors). device: null if the CPU works
/// alone. If the request asks for an impossible strategy, a usage error says why, without the name of an option. Any
/// thread may call it.
Result<CutPlan> planCut(const PlanRequest& request, const grid::BlockSet& blocks, const DeviceProfile* device);

} // namespace vp::find
