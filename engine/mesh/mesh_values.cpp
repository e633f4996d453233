#include "mesh/mesh_values.h"

#include "grid/shown_value.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::mesh
{

double interpolate(const grid::Block& block, const grid::Field& field, int component, const EdgePoint& at)
{
	const auto sources = std::visit(
	    [&](const auto& grid) {
		    return std::pair{grid.sourcePoint(at.lower), grid.sourcePoint(at.higher)};
	    },
	    block.grid);
	return grid::shownValue(field.components, component,
	                        [&](int c)
	                        {
		                        const double a = field.value(sources.first, c);
		                        // An end that has no part in the vertex does not bring its NaN to it.
		                        if (at.t == 0.0)
			                        return a;
		                        const double b = field.value(sources.second, c);
		                        if (field.categorical)
			                        return at.t < 0.5 ? a : at.t > 0.5 ? b : std::min(a, b);
		                        // Between two equal infinities there is no difference to take a part of.
		                        return at.t == 1.0 || a == b ? b : a + at.t * (b - a);
	                        });
}

double vertexValue(const grid::BlockSet& blocks, const SheetMesh& mesh, std::size_t vertex,
                   std::span<const grid::Field* const> fields, int component)
{
	constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
	if (vertex < mesh.edges.size())
	{
		const EdgePoint& edge = mesh.edges[vertex];
		const grid::Field* field = fields[edge.block];
		const bool known = field && component < field->components;
		return known ? interpolate(blocks.blocks[edge.block], *field, component, edge) : kNan;
	}
	int components = 1;
	const auto componentAt = [&](int c)
	{
		double sum = 0.0;
		double most = 0.0;
		for (const PointShare& share : mesh.rimShares(vertex))
		{
			const grid::Field* field = fields[share.block];
			if (!field || c >= field->components)
				return kNan;
			components = field->components;
			const auto source = std::visit([&](const auto& grid) { return std::size_t(grid.sourcePoint(share.point)); },
			                               blocks.blocks[share.block].grid);
			const double value = field->value(source, c);
			if (!field->categorical)
				sum += share.weight * value;
			else if (share.weight > most)
			{
				most = share.weight;
				sum = value;
			}
		}
		return sum;
	};
	const double first = componentAt(std::max(component, 0));
	return component != grid::kMagnitude || std::isnan(first) ? first
	                                                          : grid::shownValue(components, component, componentAt);
}

double cellValue(const grid::Block& block, const grid::Field& field, int component, CellId cell)
{
	const std::size_t source =
	    std::visit([&](const auto& grid) { return std::size_t(grid.sourceCell(cell)); }, block.grid);
	return grid::shownValue(field, source, component);
}

} // namespace vp::mesh
