#include "find/threshold.h"

#include "grid/shown_value.h"

#include <limits>

namespace vp::find
{

namespace
{

template <grid::Grid G>
bool hasPart(const G& grid, const grid::Field& field, int component, CellId cell, const Threshold& threshold)
{
	double lo = std::numeric_limits<double>::infinity();
	double hi = -lo;
	const auto add = [&](double value)
	{
		lo = value < lo ? value : lo; // a NaN changes nothing
		hi = value > hi ? value : hi;
	};
	if (field.association == grid::Association::cell)
		add(grid::shownValue(field, grid.sourceCell(cell), component));
	else
	{
		grid::CellFaces faces;
		grid.cellFaces(cell, faces);
		for (const PointId p : faces.points)
			add(grid::shownValue(field, grid.sourcePoint(p), component));
	}
	return lo <= threshold.hi && hi >= threshold.lo;
}

} // namespace

grid::CellFilter cellsWithin(const grid::Block& block, const grid::FieldChoice& choice, const Threshold& threshold)
{
	const grid::Field* field = choice.in(block);
	if (!field)
		return [](CellId) { return false; };
	return [&block, field, component = choice.component, threshold](CellId cell) {
		return std::visit([&](const auto& grid) { return hasPart(grid, *field, component, cell, threshold); },
		                  block.grid);
	};
}

} // namespace vp::find
