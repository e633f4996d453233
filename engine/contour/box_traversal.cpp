#include "contour/box_traversal.h"

#include <utility>

namespace vp::contour
{

BoxTraversal::BoxTraversal(const cut::Cutter& cutter, const std::vector<surface::BlockSurface>& surfaces,
                           const ClipBox& box)
{
	const grid::BlockSet& blocks = cutter.blocks();
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
	{
		marks_.push_back(cutter.borrowMarks(b));
		sheets_.push_back({.block = &blocks.blocks[b],
		                   .surface = surfaces[b],
		                   .visited = marks_.back().get(),
		                   .seeds = {},
		                   .seams = blocks.interfaces.of(b),
		                   .first_block = 0,
		                   .filter = find::finiteCells(blocks.blocks[b], surfaces[b]),
		                   .window = box});
	}
}

Result<std::vector<find::CellCut>> BoxTraversal::searchFrom(std::vector<std::vector<CellId>> seeds,
                                                            std::stop_token stop)
{
	for (std::size_t b = 0; b < sheets_.size(); ++b)
		sheets_[b].seeds = std::move(seeds[b]);
	classify::CpuClassifier<surface::BlockSurface, ClipBox> classifier(sheets_);
	return find::breadthFirst<surface::BlockSurface, ClipBox>(sheets_, classifier, std::move(stop));
}

Result<std::vector<find::CellCut>> BoxTraversal::searchFrom(std::size_t block, CellId seed, std::stop_token stop)
{
	std::vector<std::vector<CellId>> seeds(sheets_.size());
	seeds[block].push_back(seed);
	return searchFrom(std::move(seeds), std::move(stop));
}

} // namespace vp::contour
