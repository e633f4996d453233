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

/// How the cut cells of a sheet in a block are found. All strategies find the same cells.
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

/// The strategy that a name stands for; none for other words.
std::optional<Strategy> strategyNamed(std::string_view name);
const char* nameOf(Strategy strategy);
const char* nameOf(Processor classifier);

/// Which strategies a plan chooses from where none is asked for by name. All find the same cells, and make the same
/// mesh but for the numbering. What is not found in generations goes to a device's classifier as one wide front.
enum class Finder
{
	traversal, // generations alone
	direct,    // rows where they can be had, else generations
	automatic  // the fastest that can be had
};

/// What a plan has to know of a request.
struct PlanRequest
{
	std::span<const probe::Sheet> sheets;   // the plan keeps none
	const ListedSurface* surface = nullptr; // in place of the sheets, or null
	bool has_threshold = false;             // of values: cells outside end the search
	seed::SeedMode seed_mode = seed::SeedMode::boundary;
	bool looks_for_hot_spot = false; // whether the hot spot lies in the grid has to be known
	bool another_follows = false;    // so that it pays to build neighbors, where they are not known
	Finder finder = Finder::traversal;
	std::optional<Strategy> strategy; // for all sheets and blocks; an error where it cannot be had
};

/// The way of one sheet in one block.
struct BlockPlan
{
	Strategy strategy = Strategy::generations;
	Processor classifier = Processor::cpu;
	const char* why_strategy = "";
	const char* why_classifier = ""; // empty where nothing needs to be said

	/// A few words: why this strategy, and, where a device is left out, why.
	std::string reason() const;
};

/// The way of every sheet in every block: sheets[s][b]. What takes the place of the sheets counts as one sheet.
struct CutPlan
{
	std::vector<std::vector<BlockPlan>> sheets;

	/// Whether grid::buildNeighbors() is to be called before the plan can be carried out.
	bool needs_neighbors = false;
};

/// What a plan has to know of a device that classifies.
struct DeviceProfile
{
	std::vector<bool> holds; // per block: whether it is in device memory; otherwise it passed a limit of the device
};

/// How a request will be cut. A pure function that looks at no cell: the time goes by sheets times blocks, and the axes
/// of rectilinear blocks. What is built already is in the blocks (grid::hasNeighbors). device: null where the CPU works
/// alone. A usage error, without an option's name, says why a strategy that the request asks for cannot be had.
/// Threads: any.
Result<CutPlan> planCut(const PlanRequest& request, const grid::BlockSet& blocks, const DeviceProfile* device);

} // namespace vp::find
