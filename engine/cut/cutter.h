#pragma once

#include "base/result.h"
#include "cut/cut.h"
#include "cut/request.h"
#include "find/curved_sheet.h"
#include "find/find_block.h"
#include "find/plan.h"
#include "grid/block.h"
#include "grid/cell_filter.h"
#include "surface/curved.h"
#include "surface/plane.h"

#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace vp
{
class Timeline;
}
namespace vp::classify
{
class GpuBlocks; // the block set on the device (gpu_blocks.h)
}
namespace vp::gpu
{
class Device;
}

namespace vp::cut
{

template <class Surface>
struct SheetGroup; // sheets that are searched together (sheet_group.h)

/// A cut under way. Destroying the ticket cancels it and waits.
class CutTicket
{
public:
	CutTicket(std::stop_source stop, std::future<Result<Cut>> result)
	    : stop_(std::move(stop)), result_(std::move(result))
	{
	}
	CutTicket(CutTicket&&) = default;
	CutTicket& operator=(CutTicket&&) = delete;
	~CutTicket();

	void cancel() { stop_.request_stop(); }      // wait() then gives what was found until then
	Result<Cut> wait() { return result_.get(); } // once

private:
	std::stop_source stop_;
	std::future<Result<Cut>> result_;
};

/// Cuts a block set by probes, in the steps of docs/CUTTING.md. Holds what cuts share: marks and, with a device, the
/// blocks in device memory. Thread safe; several cuts may be under way.
class Cutter
{
public:
	explicit Cutter(const grid::BlockSet& blocks); // CPU classifier
	// GPU classifier; uploads the blocks (section "upload"). Blocks past a limit of the device stay with the CPU: see
	// Cut::warnings.
	static Result<std::unique_ptr<Cutter>> onDevice(gpu::Device& device, const grid::BlockSet& blocks,
	                                                const std::optional<grid::FieldChoice>& field, Timeline* timeline);
	~Cutter();

	// The way that begin() and cut() go with a request. Its origins and normals make no difference.
	Result<find::CutPlan> plan(const CutRequest& request) const;

	CutTicket begin(CutRequest request);
	/// Asked to stop, it gives what was found until then.
	Result<Cut> cut(const CutRequest& request, std::stop_token stop = {}) { return run(request, std::move(stop)); }

	// After the blocks' values changed, and nothing else: their copies on the device are dropped.
	void forgetValues();
	// The same cut over the values there are now: what was cut is kept, nothing is traversed.
	Result<Cut> regather(const Cut& kept, Timeline* timeline);

	// Marks of a block's cells for another search than a cut, such as what is grown from a sheet.
	find::VisitedPool::Loan borrowMarks(std::size_t block) { return stores_[block]->visited.borrow(); }

	const grid::BlockSet& blocks() const { return blocks_; }
	bool usesGpu() const { return gpu_ != nullptr; }
	std::size_t blocksOnGpu() const; // the others passed a limit of the device, and are classified by the CPU

	// Bytes kept from cut to cut; while none is under way.
	struct Memory
	{
		std::size_t marks = 0;  // of the host: visited marks, rows of spans
		std::size_t device = 0; // blocks, values and records, see GpuBlocks
	};
	Memory memory() const;

private:
	using Previous = std::vector<const SheetCut*>; // per sheet, as it was, null where it is new; or none at all

	Result<Cut> run(const CutRequest& request, std::stop_token stop);
	Result<Cut> cutAll(const CutRequest& request, const Previous& previous, std::stop_token stop);
	Cut listSurface(const CutRequest& request) const;
	std::vector<grid::CellFilter> thresholdFilters(const CutRequest& request) const; // per block
	// Groups of sheets, with their seeds.
	template <class Surface>
	SheetGroup<Surface> groupOf(const CutRequest& request, const find::CutPlan& plan,
	                            std::vector<std::size_t> numbers) const;
	SheetGroup<surface::Plane> planesOf(const CutRequest& request, const find::CutPlan& plan,
	                                    std::vector<std::size_t> numbers) const;
	SheetGroup<surface::BlockSurface> curvedSheetOf(const CutRequest& request, const find::CutPlan& plan,
	                                                std::size_t number);
	template <class Surface>
	void scan(SheetGroup<Surface>& group) const;
	void findKnown(SheetGroup<surface::Plane>& group);
	void addSeeds(SheetGroup<surface::Plane>& group, const Previous& previous) const;
	Status search(SheetGroup<surface::Plane>& group, const Previous& previous, std::stop_token stop);
	Status search(SheetGroup<surface::BlockSurface>& group, std::stop_token stop);

	const grid::BlockSet& blocks_;
	std::vector<std::unique_ptr<find::BlockStores>> stores_; // per block
	find::ValueRanges ranges_;                               // for iso values
	std::shared_ptr<classify::GpuBlocks> gpu_;
};

} // namespace vp::cut
