#include "viewer/panels/cut_figures.h"

#include <algorithm>

namespace vp::app
{

CutFigures figuresOf(const session::Frame& cut, std::size_t sheet)
{
	const cut::SheetCut& slice = cut.slice.sheets[sheet];
	CutFigures figures;
	figures.polygons = cut.sheets[sheet].mesh.polygons();
	for (const find::BlockCut& in_block : slice.cuts)
	{
		figures.cut_cells += in_block.cutCells();
		figures.touched += in_block.touchedCells();
		figures.generations = std::max(figures.generations, in_block.steps());
		figures.front_max = std::max(figures.front_max, in_block.frontMax());
	}
	return figures;
}

CutFigures figuresOf(const session::Frame& cut)
{
	CutFigures all;
	for (std::size_t s = 0; s < cut.slice.sheets.size(); ++s)
	{
		const CutFigures one = figuresOf(cut, s);
		all.cut_cells += one.cut_cells;
		all.touched += one.touched;
		all.generations = std::max(all.generations, one.generations);
		all.front_max = std::max(all.front_max, one.front_max);
		all.polygons += one.polygons;
	}
	return all;
}

} // namespace vp::app
