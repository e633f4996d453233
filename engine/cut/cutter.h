#pragma once

#include "base/result.h"
#include "cut/cut.h"
#include "cut/request.h"
#include "find/curved_sheet.h"
#include "find/find_block.h"
#include "find/plan.h"
#include "grid/block.h"
#include "grid/cell_filter.h"
#include "refine/refiner.h"
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

/// A running cut. The destructor cancels it and waits.
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

/// Cuts a block set with probes, in the steps of docs/CUTTING.md. It keeps what cuts share: marks and, with a device,
/// the blocks in device memory. Thread safe. Several cuts may run at the same time.
class Cutter
{
public:
	explicit Cutter(const grid::BlockSet& blocks); // CPU classifier
	// Uses the GPU classifier, and uploads the blocks (section "upload"). The CPU classifies the blocks that exceed a
	// device limit, see Cut::warnings.
	static Result<std::unique_ptr<Cutter>> onDevice(gpu::Device& device, const grid::BlockSet& blocks,
	                                                const std::optional<grid::FieldChoice>& field, Timeline* timeline);
	~Cutter();

	// Returns the plan by which begin() and cut() work on a request. It does not depend on origins and normals.
	Result<find::CutPlan> plan(const CutRequest& request) const;

	/// Returns the seeds with which cut() would begin, per sheet. The plan must not scan.
	Result<std::vector<seed::SheetSeeds>> seedsOf(const CutRequest& request);

	CutTicket begin(CutRequest request);
	/// If it is asked to stop, it returns what it has found.
	Result<Cut> cut(const CutRequest& request, std::stop_token stop = {}) { return run(request, std::move(stop)); }

	// Call this if only the values of the blocks have changed. It drops their copies on the device.
	void forgetValues();
	// Returns the same cut with the present values. The cells of the cut are kept, and nothing is traversed.
	Result<Cut> regather(const Cut& kept, Timeline* timeline);

	// Returns marks of a block's cells for a search that is not a cut, such as one that grows a contour from a sheet.
	find::VisitedPool::Loan borrowMarks(std::size_t block) const { return stores_[block]->visited.borrow(); }

	const grid::BlockSet& blocks() const { return blocks_; }
	bool usesGpu() const { return gpu_ != nullptr; }
	std::size_t blocksOnGpu() const; // the CPU classifies the others, which exceed a limit of the device

	// Returns the bytes that are kept from cut to cut. Do not call this during a cut.
	struct Memory
	{
		std::size_t marks = 0;  // in host memory: visited marks, rows of spans
		std::size_t device = 0; // blocks, values and records, see GpuBlocks
	};
	Memory memory() const;

private:
	using Previous = std::vector<const SheetCut*>; // per sheet: the earlier one, null if it is new; or empty

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
	Status scan(SheetGroup<Surface>& group) const;
	void findKnown(SheetGroup<surface::Plane>& group);
	void addSeeds(SheetGroup<surface::Plane>& group, const Previous& previous) const;
	Status search(SheetGroup<surface::Plane>& group, const Previous& previous, std::stop_token stop);
	Status search(SheetGroup<surface::BlockSurface>& group, std::stop_token stop);

	const grid::BlockSet& blocks_;
	std::vector<std::unique_ptr<find::BlockStores>> stores_; // per block
	find::ValueRanges ranges_;                               // for iso values
	std::unique_ptr<refine::Refiner> refiner_;               // null if no block has curved cells
	std::shared_ptr<classify::GpuBlocks> gpu_;
};

} // namespace vp::cut
