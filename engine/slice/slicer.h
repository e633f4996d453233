#pragma once

#include "base/pool.h"
#include "base/result.h"
#include "grid/block.h"
#include "probe/probe.h"
#include "seed/seeds.h"
#include "slice/clip.h"
#include "slice/curved_sheet.h"
#include "slice/cut_plan.h"
#include "slice/field_choice.h"
#include "slice/mesh.h"
#include "slice/other_surface.h"
#include "slice/threshold.h"
#include "traverse/bfs.h"
#include "traverse/cell_marks.h"
#include "traverse/span_store.h"

#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace vp
{
class Timeline;
}
namespace vp::gpu
{
class Device;
}

namespace vp::slice
{

class GpuBlocks;     // the block set on the device (gpu_blocks.h)
class GpuClassifier; // gpu_classifier.h
struct SheetRecords; // a sheet's polygons in device memory (gpu_records.h)

struct Slice;

// Which strategies a plan chooses from where none is asked for by name. All find the same cells, and make the same mesh
// but for the numbering. What is not found in generations goes to a device's classifier as one wide front.
enum class Finder
{
	traversal, // generations alone
	direct,    // rows where they can be had, else generations
	automatic  // the fastest that can be had
};

// How the traversal knows the cells that it has queued.
enum class Visited
{
	stamps, // a byte a cell (traverse/visited.h)
	octants // the queue is searched, nothing is kept over the grid (traverse/octant_queue.h)
};

struct SliceRequest
{
	probe::Probe probe;
	Corners corners = Corners::keep; // of windows
	std::optional<FieldChoice> field;
	// Per sheet, in place of `field`; or empty.
	std::vector<std::optional<FieldChoice>> sheet_fields;
	seed::SeedOptions seeds;
	std::optional<Threshold> threshold; // of the field's values: cells outside end the traversal
	Finder finder = Finder::traversal;
	std::optional<Strategy> strategy; // for all sheets and blocks; an error where it cannot be had
	Visited visited = Visited::stamps;
	// Takes the place of the probe's sheets. It needs no search, and windows and seeds mean nothing to it.
	std::optional<OtherSurface> surface;
	// A slice by a request that differed from this one in the probe alone, over the same blocks and values; or null.
	// Its sheets that stand where they stood, to the last bit, are taken from it and not cut again.
	std::shared_ptr<const Slice> last;
	// Sections "seed", "traverse" with "classify" and "expand" of each generation, "emit". Must outlive the ticket.
	Timeline* timeline = nullptr;
};

// One sheet's share of a slice.
struct SheetSlice
{
	probe::Sheet shown; // as the probe places it in the world
	probe::Sheet sheet; // what it shows: where fx does nothing the same, see probe::content()
	Corners corners = Corners::keep;
	std::optional<FieldChoice> field;
	seed::SheetSeeds seeds;
	std::vector<traverse::LaneCut> cuts; // per block; without a device empty where spans were found instead
	// Per block, or empty.
	std::vector<std::optional<traverse::SpanCut>> spans;
	std::shared_ptr<SheetRecords> records; // GPU classifier only: the polygons in device memory, as they are drawn
	std::optional<OtherSurface> surface;   // shown in place of the sheet, whose frame means nothing then
	// Of the cut: sheets of two slices with one number are the same, and over the same values so are their meshes.
	std::uint64_t number = 0;

	bool isPlane() const { return !surface && !sheet.form; }
	bool hasSpans(std::size_t block) const { return !spans.empty() && spans[block]; }
	std::size_t cutCells(std::size_t block) const
	{
		return hasSpans(block) ? spans[block]->cells.cut : cuts[block].cut_cells;
	}
	// Whether they turned out to count or not.
	std::size_t touchedCells(std::size_t block) const
	{
		return hasSpans(block) ? spans[block]->cells.looked_at : cuts[block].cells.size();
	}
};

// Of a sheet that is no plane: "i=12.5", "sphere:2".
std::string surfaceName(const SheetSlice& sheet);

struct Slice
{
	std::vector<SheetSlice> sheets;
	std::vector<std::string> words; // for the user, such as why cells were left to the CPU

	// The indexed mesh of a sheet within its window, built on the CPU from the traversal's cells.
	SheetMesh mesh(const grid::BlockSet& blocks, std::size_t sheet) const;
	// The whole cells that a sheet shows in its window, see crinkle.h.
	SheetMesh crinkle(const grid::BlockSet& blocks, std::size_t sheet) const;
};

class Slicer;

// A slice under way. Destroying the ticket cancels it and waits.
class SliceTicket
{
public:
	SliceTicket(std::stop_source stop, std::future<Result<Slice>> result);
	SliceTicket(SliceTicket&&) = default;
	SliceTicket& operator=(SliceTicket&&) = delete;
	~SliceTicket();

	void cancel();        // wait() then gives what was found until then
	Result<Slice> wait(); // once

private:
	std::stop_source stop_;
	std::future<Result<Slice>> result_;
};

// Cuts a block set by probes. Holds what slices share: visited marks and, with a device, the blocks in device memory.
// Thread safe; several slices may be under way.
class Slicer
{
public:
	explicit Slicer(const grid::BlockSet& blocks); // CPU classifier
	// GPU classifier; uploads the blocks (section "upload"). Blocks past a limit of the device stay with the CPU: see
	// words().
	static Result<std::unique_ptr<Slicer>> onDevice(gpu::Device& device, const grid::BlockSet& blocks,
	                                                const std::optional<FieldChoice>& field, Timeline* timeline);
	~Slicer();

	// The way that begin() and cut() go with a request. Its origins and normals make no difference.
	Result<CutPlan> plan(const SliceRequest& request) const;

	SliceTicket begin(SliceRequest request);
	Result<Slice> cut(const SliceRequest& request) { return run(request, {}); }

	// After the blocks' values changed, and nothing else: their copies on the device are dropped.
	void forgetValues();
	// The same slice over the values there are now: what was cut is kept, nothing is traversed.
	Result<Slice> regather(const Slice& kept, Timeline* timeline);

	// Marks of a block's cells for another traversal than a slice's, such as what is grown from a sheet.
	traverse::VisitedPool::Loan borrowMarks(std::size_t block) { return visited_[block]->borrow(); }

	const grid::BlockSet& blocks() const { return blocks_; }
	bool usesGpu() const { return gpu_ != nullptr; }
	std::size_t blocksOnGpu() const; // the others passed a limit of the device, and are classified by the CPU

	// Bytes kept from slice to slice; while none is under way.
	struct Memory
	{
		std::size_t marks = 0;  // of the host: visited marks, rows of spans
		std::size_t device = 0; // blocks, values and records, see GpuBlocks
	};
	Memory memory() const;

private:
	using Lane = traverse::Lane<surface::Plane>;

	using Admits = std::vector<std::function<bool(CellId)>>; // per block
	struct Lanes;

	Slice seedSheets(const SliceRequest& request, const Admits& admits) const;
	Result<Slice> run(const SliceRequest& request, std::stop_token stop);
	Result<Slice> cutMoved(const SliceRequest& request, std::stop_token stop);
	// The sheets as they were, one each, null where one is new; or none at all.
	using Before = std::vector<const SheetSlice*>;
	Result<Slice> cutAll(const SliceRequest& request, const Before& before, std::stop_token stop);
	Slice showSurface(const SliceRequest& request, const Admits& admits) const;
	// slicer_curved.cpp
	Result<Slice> cutForms(const SliceRequest& request, const std::vector<bool>& has_form, const Before& before,
	                       std::stop_token stop);
	using CurvedLane = traverse::Lane<surface::BlockSurface>; // of one sheet: one a block
	Result<std::vector<traverse::LaneCut>> traverseForm(const SliceRequest& request, std::span<CurvedLane> lanes,
	                                                    std::stop_token stop);
	Result<SheetSlice> cutForm(const SliceRequest& request, const probe::Sheet& sheet,
	                           const std::optional<FieldChoice>& field, std::stop_token stop);
	Admits admitsOf(const SliceRequest& request) const;
	// Per lane; none where the traversal is to find the cells.
	using Found = std::vector<std::optional<traverse::LaneCut>>;

	traverse::SpanCut spansOf(const SheetSlice& sheet, std::size_t block);
	traverse::LaneCut floodCells(const SheetSlice& sheet, std::size_t block);
	Found find(const SliceRequest& request, const CutPlan& plan, Slice& slice);
	void spreadSeeds(const SliceRequest& request, const Before& before, const Found& found, Slice& slice) const;
	Lanes makeLanes(const SliceRequest& request, const Slice& slice, const Found& found, const Admits& admits);
	Result<std::vector<traverse::LaneCut>> traverseOnCpu(const SliceRequest& request, std::span<Lane> lanes,
	                                                     std::stop_token stop);
	Result<std::vector<traverse::LaneCut>> traverseOnGpu(const SliceRequest& request, std::span<Lane> lanes,
	                                                     Found& found, Slice& slice, std::stop_token stop);
	Result<std::unique_ptr<GpuClassifier>> gpuClassifier(const Slice& slice, Timeline* timeline);
	static Status classifyFound(GpuClassifier& classifier, Found& found);
	static void walkFound(std::span<const Lane> lanes, Found& found);
	void takeRecords(GpuClassifier& classifier, Slice& slice);
	Status addHostRecords(Timeline* timeline, Slice& slice) const;

	const grid::BlockSet& blocks_;
	std::vector<std::unique_ptr<traverse::VisitedPool>> visited_;    // per block
	std::vector<std::unique_ptr<Pool<traverse::SpanStore>>> stores_; // per block
	std::vector<std::unique_ptr<Pool<traverse::CellMarks>>> marks_;  // per block
	ValueRanges ranges_;                                             // for iso values
	std::shared_ptr<GpuBlocks> gpu_;
};

} // namespace vp::slice
