#pragma once

#include "base/result.h"
#include "classify/cpu_classifier.h"
#include "contour/clip_box.h"
#include "cut/cutter.h"
#include "find/generations.h"
#include "grid/field_choice.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace vp::contour
{

// The traversal of an iso surface in a box. Searches that follow each other share their marks: a cell belongs to the
// first that reaches it.
class BoxTraversal
{
public:
	// surfaces: as each block of the cutter sees the iso surface. Both outlive this.
	BoxTraversal(const cut::Cutter& cutter, const std::vector<surface::BlockSurface>& surfaces, const ClipBox& box);
	BoxTraversal(const BoxTraversal&) = delete;

	// Returns what is found from these cells, per block.
	Result<std::vector<find::CellCut>> searchFrom(std::vector<std::vector<CellId>> seeds, std::stop_token stop = {});
	Result<std::vector<find::CellCut>> searchFrom(std::size_t block, CellId seed, std::stop_token stop = {});

private:
	using ClippedSurface = find::SheetInBlock<surface::BlockSurface, ClipBox>;

	std::vector<find::VisitedPool::Loan> marks_;
	std::vector<ClippedSurface> sheets_;
};

} // namespace vp::contour
