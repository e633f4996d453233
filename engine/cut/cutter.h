#pragma once

#include "base/pool.h"
#include "base/result.h"
#include "find/cell_marks.h"
#include "find/curved_sheet.h"
#include "find/generations.h"
#include "find/listed.h"
#include "find/plan.h"
#include "find/span_store.h"
#include "find/threshold.h"
#include "grid/block.h"
#include "grid/field_choice.h"
#include "mesh/clip.h"
#include "mesh/sheet_mesh.h"
#include "probe/probe.h"
#include "seed/seeds.h"

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

namespace vp::classify
{
class GpuBlocks;     // the block set on the device (gpu_blocks.h)
class GpuClassifier; // gpu_classifier.h
struct SheetRecords; // a sheet's polygons in device memory (gpu_records.h)
} // namespace vp::classify

namespace vp::cut
{

struct Cut;

struct CutRequest
{
	probe::Probe probe;
	mesh::Corners corners = mesh::Corners::keep; // of windows
	std::optional<grid::FieldChoice> field;
	// Per sheet, in place of `field`; or empty.
	std::vector<std::optional<grid::FieldChoice>> sheet_fields;
	seed::SeedOptions seeds;
	std::optional<find::Threshold> threshold; // of the field's values: cells outside end the traversal
	find::Finder finder = find::Finder::traversal;
	std::optional<find::Strategy> strategy; // for all sheets and blocks; an error where it cannot be had
	find::VisitedSet visited = find::VisitedSet::stamps;
	// Takes the place of the probe's sheets. It needs no search, and windows and seeds mean nothing to it.
	std::optional<find::ListedSurface> surface;
	// A slice by a request that differed from this one in the probe alone, over the same blocks and values; or null.
	// Its sheets that stand where they stood, to the last bit, are taken from it and not cut again.
	std::shared_ptr<const Cut> last;
	// Sections "seed", "traverse" with "classify" and "expand" of each generation, "emit". Must outlive the ticket.
	Timeline* timeline = nullptr;
};

/// What a plan has to know of a request, which must outlive it.
find::PlanRequest planRequestOf(const CutRequest& request);

// One sheet's share of a slice.
struct SheetCut
{
	probe::Sheet shown; // as the probe places it in the world
	probe::Sheet sheet; // what it shows: where fx does nothing the same, see probe::content()
	mesh::Corners corners = mesh::Corners::keep;
	std::optional<grid::FieldChoice> field;
	seed::SheetSeeds seeds;
	std::vector<find::CellCut> cuts; // per block; without a device empty where spans were found instead
	// Per block, or empty.
	std::vector<std::optional<find::SpanCut>> spans;
	std::shared_ptr<classify::SheetRecords>
	    records;                                // GPU classifier only: the polygons in device memory, as they are drawn
	std::optional<find::ListedSurface> surface; // shown in place of the sheet, whose frame means nothing then
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
std::string surfaceName(const SheetCut& sheet);

struct Cut
{
	std::vector<SheetCut> sheets;
	std::vector<std::string> words; // for the user, such as why cells were left to the CPU

	// The indexed mesh of a sheet within its window, built on the CPU from the traversal's cells.
	mesh::SheetMesh mesh(const grid::BlockSet& blocks, std::size_t sheet) const;
	// The whole cells that a sheet shows in its window, see crinkle.h.
	mesh::SheetMesh crinkle(const grid::BlockSet& blocks, std::size_t sheet) const;
};

class Cutter;

// A slice under way. Destroying the ticket cancels it and waits.
class CutTicket
{
public:
	CutTicket(std::stop_source stop, std::future<Result<Cut>> result);
	CutTicket(CutTicket&&) = default;
	CutTicket& operator=(CutTicket&&) = delete;
	~CutTicket();

	void cancel();      // wait() then gives what was found until then
	Result<Cut> wait(); // once

private:
	std::stop_source stop_;
	std::future<Result<Cut>> result_;
};

// Cuts a block set by probes. Holds what slices share: visited marks and, with a device, the blocks in device memory.
// Thread safe; several slices may be under way.
class Cutter
{
public:
	explicit Cutter(const grid::BlockSet& blocks); // CPU classifier
	// GPU classifier; uploads the blocks (section "upload"). Blocks past a limit of the device stay with the CPU: see
	// words().
	static Result<std::unique_ptr<Cutter>> onDevice(gpu::Device& device, const grid::BlockSet& blocks,
	                                                const std::optional<grid::FieldChoice>& field, Timeline* timeline);
	~Cutter();

	// The way that begin() and cut() go with a request. Its origins and normals make no difference.
	Result<find::CutPlan> plan(const CutRequest& request) const;

	CutTicket begin(CutRequest request);
	Result<Cut> cut(const CutRequest& request) { return run(request, {}); }

	// After the blocks' values changed, and nothing else: their copies on the device are dropped.
	void forgetValues();
	// The same slice over the values there are now: what was cut is kept, nothing is traversed.
	Result<Cut> regather(const Cut& kept, Timeline* timeline);

	// Marks of a block's cells for another traversal than a slice's, such as what is grown from a sheet.
	find::VisitedPool::Loan borrowMarks(std::size_t block) { return visited_[block]->borrow(); }

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
	using PlaneInBlock = find::SheetInBlock<surface::Plane>;

	using Admits = std::vector<std::function<bool(CellId)>>; // per block
	struct Lanes;

	Cut seedSheets(const CutRequest& request, const Admits& admits) const;
	Result<Cut> run(const CutRequest& request, std::stop_token stop);
	Result<Cut> cutMoved(const CutRequest& request, std::stop_token stop);
	// The sheets as they were, one each, null where one is new; or none at all.
	using Before = std::vector<const SheetCut*>;
	Result<Cut> cutAll(const CutRequest& request, const Before& before, std::stop_token stop);
	Cut showSurface(const CutRequest& request, const Admits& admits) const;
	// slicer_curved.cpp
	Result<Cut> cutForms(const CutRequest& request, const std::vector<bool>& has_form, const Before& before,
	                     std::stop_token stop);
	using CurvedLane = find::SheetInBlock<surface::BlockSurface>; // of one sheet: one a block
	Result<std::vector<find::CellCut>> traverseForm(const CutRequest& request, std::span<CurvedLane> lanes,
	                                                std::stop_token stop);
	Result<SheetCut> cutForm(const CutRequest& request, const probe::Sheet& sheet,
	                         const std::optional<grid::FieldChoice>& field, std::stop_token stop);
	Admits admitsOf(const CutRequest& request) const;
	// Per lane; none where the traversal is to find the cells.
	using Found = std::vector<std::optional<find::CellCut>>;

	find::SpanCut spansOf(const SheetCut& sheet, std::size_t block);
	find::CellCut floodCells(const SheetCut& sheet, std::size_t block);
	Found find(const CutRequest& request, const find::CutPlan& plan, Cut& slice);
	void spreadSeeds(const CutRequest& request, const Before& before, const Found& found, Cut& slice) const;
	Lanes makeLanes(const CutRequest& request, const Cut& slice, const Found& found, const Admits& admits);
	Result<std::vector<find::CellCut>> traverseOnCpu(const CutRequest& request, std::span<PlaneInBlock> lanes,
	                                                 std::stop_token stop);
	Result<std::vector<find::CellCut>> traverseOnGpu(const CutRequest& request, std::span<PlaneInBlock> lanes,
	                                                 Found& found, Cut& slice, std::stop_token stop);
	Result<std::unique_ptr<classify::GpuClassifier>> gpuClassifier(const Cut& slice, Timeline* timeline);
	static Status classifyFound(classify::GpuClassifier& classifier, Found& found);
	static void walkFound(std::span<const PlaneInBlock> lanes, Found& found);
	void takeRecords(classify::GpuClassifier& classifier, Cut& slice);
	Status addHostRecords(Timeline* timeline, Cut& slice) const;

	const grid::BlockSet& blocks_;
	std::vector<std::unique_ptr<find::VisitedPool>> visited_;    // per block
	std::vector<std::unique_ptr<Pool<find::SpanStore>>> stores_; // per block
	std::vector<std::unique_ptr<Pool<find::CellMarks>>> marks_;  // per block
	find::ValueRanges ranges_;                                   // for iso values
	std::shared_ptr<classify::GpuBlocks> gpu_;
};

} // namespace vp::cut
