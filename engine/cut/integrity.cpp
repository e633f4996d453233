#include "cut/integrity.h"

#include "cases/case_table.h"

#include <algorithm>
#include <cmath>

namespace vp::cut
{

namespace
{

constexpr int kMinPlanes = 16;
constexpr int kMaxPlanes = 128;

// Number of sheets that move through the grid together: fronts are wide for the GPU, and there are few marks.
constexpr int kSheetsAtOnce = 8;

// A plane cuts cells that are boxes only in cases that the tables have.
bool hasCellsOfAnyForm(const grid::BlockSet& blocks)
{
	return std::ranges::any_of(blocks.blocks,
	                           [](const grid::Block& block)
	                           {
		                           return !std::holds_alternative<grid::UniformGrid>(block.grid) &&
		                                  !std::holds_alternative<grid::RectilinearGrid>(block.grid);
	                           });
}

void collect(const grid::Block& block, std::uint32_t number, const find::CellCut& cut,
             std::vector<grid::SetCell>& impossible)
{
	std::visit(
	    [&](const auto& grid)
	    {
		    for (std::size_t i = 0; i < cut.cells.size(); ++i)
		    {
			    // Cases without an entry are walked.
			    if (!(cut.codes[i] & shared::kCodeWalk))
				    continue;
			    const grid::CellShape shape = grid.shape(cut.cells[i]);
			    if (shape != grid::CellShape::polyhedron && cases::caseTable(shape)[cut.codes[i] & 0xFFu].needs_walk)
				    impossible.push_back({number, cut.cells[i]});
		    }
	    },
	    block.grid);
}

} // namespace

Result<SweepFindings> sweepForImpossibleCases(Cutter& slicer)
{
	SweepFindings findings;
	const grid::BlockSet& blocks = slicer.blocks();
	if (!hasCellsOfAnyForm(blocks) || blocks.bounds().empty())
		return findings;
	const int planes = std::clamp(static_cast<int>(std::lround(std::cbrt(static_cast<double>(blocks.cellCount())))),
	                              kMinPlanes, kMaxPlanes);
	const Box bounds = blocks.bounds();
	for (int axis = 0; axis < 3; ++axis)
		for (int first = 0; first < planes; first += kSheetsAtOnce)
		{
			CutRequest request;
			request.in_generations = true;
			request.seeds.mode = seed::SeedMode::boundary;
			Vec3 normal(0.0);
			normal[axis] = 1.0;
			for (int k = first; k < std::min(planes, first + kSheetsAtOnce); ++k)
			{
				// A little beside the middles, where lattices often have points too.
				Vec3 origin = bounds.center();
				origin[axis] = bounds.lo[axis] + (k + 0.4903) / planes * bounds.size()[axis];
				request.probe.sheets.push_back(probe::makeSheet(origin, normal));
			}
			Result<Cut> slice = slicer.cut(std::move(request));
			if (!slice)
				return slice.error();
			for (const SheetCut& sheet : slice->sheets)
			{
				++findings.planes;
				for (std::uint32_t b = 0; b < sheet.cuts.size(); ++b)
				{
					findings.cells += sheet.cuts[b].touchedCells();
					collect(blocks.blocks[b], b, sheet.cuts[b].cells(), findings.impossible);
				}
			}
		}
	std::ranges::sort(findings.impossible);
	findings.impossible.erase(std::unique(findings.impossible.begin(), findings.impossible.end()),
	                          findings.impossible.end());
	return findings;
}

} // namespace vp::cut
