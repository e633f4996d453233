#include "grid/curved/cells_to_points.h"

#include "base/parallel_for.h"
#include "grid/curved/curved_cells.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace vp::grid
{

namespace
{

// Calls visit(point) for each point of a cell, some of them several times.
template <class G, class Visit>
void forPointsOf(const G& grid, CellId cell, CellFaces& faces, Visit&& visit)
{
	if (grid.shape(cell) != CellShape::polyhedron)
	{
		for (const PointId point : grid.cellPoints(cell))
			visit(point);
		return;
	}
	grid.cellFaces(cell, faces);
	for (const PointId point : faces.points)
		visit(point);
}

// The cells of a grid, so that parts of one cell of the file follow each other. The ids of a listed grid have gaps.
template <class G>
std::vector<CellId> cellsInOrder(const G& grid)
{
	std::vector<CellId> cells;
	if constexpr (std::is_same_v<G, UnstructuredGrid>)
	{
		if (const CellList* list = grid.list())
		{
			if (!list->has_checked_ids)
				checkIds(list->connectivity, grid.pointCount());
			for (std::size_t c = 0; c < list->size(); ++c)
				if (isSliceable(list->types[c]))
					cells.push_back(static_cast<CellId>(c));
		}
	}
	if (cells.empty())
	{
		cells.resize(grid.cellCount());
		std::iota(cells.begin(), cells.end(), CellId(0));
	}
	if constexpr (std::is_same_v<G, UnstructuredGrid>)
		if (grid.splitsCells())
			std::stable_sort(cells.begin(), cells.end(),
			                 [&](CellId a, CellId b) { return grid.sourceCell(a) < grid.sourceCell(b); });
	return cells;
}

// Calls visit(point, cell) once for each point of each cell, as the arrays number them.
template <class Visit>
void forPointsOfCells(const Block& block, std::size_t points, Visit&& visit)
{
	constexpr std::size_t kNoCellYet = std::numeric_limits<std::size_t>::max();
	std::vector<std::size_t> last(points, kNoCellYet);
	const auto visitOnce = [&](std::size_t point, std::size_t cell)
	{
		if (last[point] == cell)
			return;
		last[point] = cell;
		visit(point, cell);
	};
	if (const CurvedCells* curved = block.curved.get())
	{
		for (std::size_t c = 0; c < curved->cells.size(); ++c)
			for (std::size_t n = 0; curved->isCut(c) && n < curved->nodes(c); ++n)
				visitOnce(curved->node(c, n), c);
		return;
	}
	std::visit(
	    [&](const auto& grid)
	    {
		    CellFaces faces;
		    for (const CellId cell : cellsInOrder(grid))
			    forPointsOf(grid, cell, faces,
			                [&](PointId point) { visitOnce(grid.sourcePoint(point), grid.sourceCell(cell)); });
	    },
	    block.grid);
}

std::size_t pointTuples(const Block& block)
{
	if (block.curved)
		return block.curved->points.size();
	if (block.hidden_lattice)
		return block.hidden_lattice->pointCount();
	return std::visit([](const auto& grid) { return grid.pointCount(); }, block.grid);
}

Field meansAtPoints(const Block& block, const Field& of_cells)
{
	const std::size_t points = pointTuples(block);
	const auto width = static_cast<std::size_t>(of_cells.components);
	std::vector<double> sums(points * width, 0.0);
	std::vector<std::uint32_t> counts(points * width, 0);
	forPointsOfCells(block, points,
	                 [&](std::size_t point, std::size_t cell)
	                 {
		                 for (std::size_t c = 0; c < width; ++c)
		                 {
			                 const double value = of_cells.value(cell, static_cast<int>(c));
			                 if (std::isnan(value))
				                 continue;
			                 sums[point * width + c] += value;
			                 ++counts[point * width + c];
		                 }
	                 });
	for (std::size_t i = 0; i < sums.size(); ++i)
		sums[i] = counts[i] > 0 ? sums[i] / counts[i] : std::numeric_limits<double>::quiet_NaN();
	Field made = of_cells.type == NumberType::float32
	                 ? makeField(of_cells.name, Association::point, of_cells.components,
	                             std::vector<float>(sums.begin(), sums.end()))
	                 : makeField(of_cells.name, Association::point, of_cells.components, std::move(sums));
	made.units = of_cells.units;
	return made;
}

} // namespace

std::vector<Field> fieldsAtPoints(const Block& block, std::vector<Field> fields)
{
	const auto isMoved = [&](const Field& field)
	{
		return field.association == Association::cell && !namesCategories(field) &&
		       std::ranges::none_of(fields, [&](const Field& other)
		                            { return other.association == Association::point && other.name == field.name; });
	};
	std::vector<std::size_t> moved;
	for (std::size_t i = 0; i < fields.size(); ++i)
		if (isMoved(fields[i]))
			moved.push_back(i);
	tracedFor(std::size_t(0), moved.size(),
	          [&](std::size_t i) { fields[moved[i]] = meansAtPoints(block, fields[moved[i]]); });
	return fields;
}

} // namespace vp::grid
