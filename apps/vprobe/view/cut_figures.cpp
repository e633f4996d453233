#include "view/cut_figures.h"

#include <algorithm>

namespace vp::app
{

CutFigures figuresOf(const CutFrame& cut, std::size_t sheet)
{
	const cut::SheetCut& slice = cut.slice.sheets[sheet];
	CutFigures figures;
	figures.polygons = cut.sheets[sheet].mesh.polygons();
	for (std::size_t b = 0; b < slice.cuts.size(); ++b)
	{
		figures.cut_cells += slice.cutCells(b);
		figures.touched += slice.touchedCells(b);
		figures.generations = std::max<std::size_t>(figures.generations, slice.cuts[b].steps);
		figures.front_max = std::max<std::size_t>(figures.front_max, slice.cuts[b].frontMax());
	}
	return figures;
}

CutFigures figuresOf(const CutFrame& cut)
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
