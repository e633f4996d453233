#include "slice/slicer.h"

#include "base/timeline.h"
#include "slice/cpu_classifier.h"

namespace vp::slice
{

SheetMesh Slice::mesh(const grid::BlockSet& blocks, std::size_t sheet) const
{
	std::vector<BlockCut> cuts;
	for (std::size_t b = 0; b < sheets[sheet].cuts.size(); ++b)
		cuts.push_back({static_cast<std::uint32_t>(b), &sheets[sheet].cuts[b], sheets[sheet].seeds.faces_in_plane[b]});
	return buildMesh(blocks, sheets[sheet].sheet, cuts);
}

SliceTicket::SliceTicket(std::stop_source stop, std::future<Result<Slice>> result)
	: stop_(std::move(stop)), result_(std::move(result))
{
}

SliceTicket::~SliceTicket()
{
	if (!result_.valid())
		return;
	cancel();
	result_.wait();
}

void SliceTicket::cancel()
{
	stop_.request_stop();
}

Result<Slice> SliceTicket::wait()
{
	return result_.get();
}

Slicer::Slicer(const grid::BlockSet& blocks) : blocks_(blocks)
{
	for (const grid::Block& block : blocks.blocks)
		visited_.push_back(std::make_unique<traverse::VisitedPool>(
			std::visit([](const auto& grid) { return grid.cellCount(); }, block.grid)));
}

Slicer::~Slicer() = default;

SliceTicket Slicer::begin(SliceRequest request)
{
	std::stop_source stop;
	return {stop, std::async(std::launch::async, [this, request = std::move(request), token = stop.get_token()]
							 { return run(request, token); })};
}

Result<Slice> Slicer::run(const SliceRequest& request, std::stop_token stop)
{
	using Lane = traverse::Lane<surface::Plane>;
	const std::size_t block_count = blocks_.blocks.size();

	Slice slice;
	{
		const TimedSection section(request.timeline, "seed");
		for (const probe::Sheet& sheet : request.probe.sheets)
			slice.sheets.push_back({sheet, seed::findSeeds(blocks_, sheet, request.seeds), {}, nullptr});
	}

	std::vector<traverse::LaneCut> cuts;
	{
		const TimedSection section(request.timeline, "traverse");
		std::vector<traverse::VisitedPool::Loan> loans;
		std::vector<Lane> lanes;
		for (const SheetSlice& sheet : slice.sheets)
			for (std::size_t b = 0; b < block_count; ++b)
			{
				loans.push_back(visited_[b]->borrow());
				lanes.push_back({&blocks_.blocks[b], sheet.sheet.plane(), loans.back().get(), sheet.seeds.cells[b]});
			}
		CpuClassifier<surface::Plane> classifier(lanes);
		Result<std::vector<traverse::LaneCut>> found =
			traverse::breadthFirst<surface::Plane>(std::span<Lane>(lanes), classifier, stop);
		if (!found)
			return found.error();
		cuts = std::move(*found);
	}
	for (std::size_t lane = 0; lane < cuts.size(); ++lane)
		slice.sheets[lane / block_count].cuts.push_back(std::move(cuts[lane]));
	return slice;
}

} // namespace vp::slice
namespace vp::slice { // TEMPORARY until the GPU classifier is in
Result<std::unique_ptr<Slicer>> Slicer::onDevice(gpu::Device&, const grid::BlockSet& blocks, const std::optional<FieldChoice>&, Timeline*) { return std::make_unique<Slicer>(blocks); }
std::size_t Slicer::blocksOnGpu() const { return 0; }
}
