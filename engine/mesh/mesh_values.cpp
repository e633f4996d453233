#include "mesh/mesh_values.h"

#include "base/parallel_for.h"
#include "base/prefetch.h"
#include "base/two_doubles.h"
#include "base/union_find.h"
#include "grid/number_types.h"
#include "grid/shown_value.h"
#include "mesh/fetch_values.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::mesh
{

namespace
{

// The value at t along an edge from the values at its ends. It is the same to the last bit if the ends change places:
// then `t` is exactly 1 minus what it was.
double alongEdge(double a, double b, double t, bool categorical)
{
	// An end that has no part in the vertex does not bring its NaN to it.
	if (t == 0.0)
		return a;
	if (categorical)
		return t < 0.5 ? a : t > 0.5 ? b : std::min(a, b);
	// Equal values stay what they are.
	return t == 1.0 || a == b ? b : (1.0 - t) * a + t * b;
}

// One component at vertices on edges. source_of(p): the number of a point in the field.
template <class Number, class SourceOf>
void interpolateEach(std::span<const EdgePoint> edges, const grid::Field& field, int component, SourceOf source_of,
                     double* values)
{
	const std::byte* numbers = field.bytes.data() + static_cast<std::size_t>(component) * sizeof(Number);
	const std::size_t stride = static_cast<std::size_t>(field.components) * sizeof(Number);
	const auto at = [=](PointId p) { return grid::numberAt<Number>(numbers + source_of(p) * stride, 0); };
	// The values at an edge's ends lie far apart in the array, so they are fetched in advance.
	constexpr std::size_t kAhead = 24;
	const auto prefetchEnds = [=](const EdgePoint& edge)
	{
		prefetch(numbers + source_of(edge.lower) * stride);
		prefetch(numbers + source_of(edge.higher) * stride);
	};
	std::size_t v = 0;
	if (!field.categorical)
		for (; v + 1 + kAhead < edges.size(); v += 2)
		{
			prefetchEnds(edges[v + kAhead]);
			prefetchEnds(edges[v + kAhead + 1]);
			const TwoDoubles a{at(edges[v].lower), at(edges[v + 1].lower)};
			const TwoDoubles b{at(edges[v].higher), at(edges[v + 1].higher)};
			const TwoDoubles t{edges[v].t, edges[v + 1].t};
			// alongEdge() has more to say about these. Sums, since one branch is faster than three.
			if (int(isAnyEqual(a, b)) + int(isAnyEqual(t, bothOf(0.0))) + int(isAnyEqual(t, bothOf(1.0))) > 0)
			    [[unlikely]]
			{
				values[v] = alongEdge(a[0], b[0], t[0], false);
				values[v + 1] = alongEdge(a[1], b[1], t[1], false);
			}
			else
				storeTwo(&values[v], (1.0 - t) * a + t * b);
		}
	for (; v < edges.size(); ++v)
	{
		prefetchEnds(edges[std::min(v + kAhead, edges.size() - 1)]);
		values[v] = alongEdge(at(edges[v].lower), at(edges[v].higher), edges[v].t, field.categorical);
	}
}

// The same of a stored array.
template <class SourceOf>
void interpolateStored(std::span<const EdgePoint> edges, const grid::Field& field, int component, SourceOf source_of,
                       double* values)
{
	for (std::size_t v = 0; v < edges.size(); ++v)
		values[v] = alongEdge(field.value(source_of(edges[v].lower), component),
		                      field.value(source_of(edges[v].higher), component), edges[v].t, field.categorical);
}

// One component at vertices on the edges of one block, without a decision for each vertex that is the same for all.
void interpolateAll(const grid::Block& block, const grid::Field& field, int component, std::span<const EdgePoint> edges,
                    double* values)
{
	const auto from = [&](auto source_of)
	{
		if (field.stored)
			return interpolateStored(edges, field, component, source_of, values);
		grid::withNumberType(field.type, [&](auto number)
		                     { interpolateEach<decltype(number)>(edges, field, component, source_of, values); });
	};
	const auto same = [](PointId p) { return std::size_t(p); };
	std::visit(
	    [&](const auto& grid)
	    {
		    using G = std::decay_t<decltype(grid)>;
		    const auto source_of = [&grid](PointId p) { return std::size_t(grid.sourcePoint(p)); };
		    if constexpr (std::is_same_v<G, grid::UnstructuredGrid>)
			    from(source_of);
		    else if constexpr (std::is_same_v<G, grid::CurvilinearGrid>)
			    grid.axes()[0] == 0 ? from(same) : from(source_of);
		    else
			    from(same);
	    },
	    block.grid);
}

// Where the values of paired vertices agree, all of them get that of the first.
void uniteAtSeams(const grid::BlockSet& blocks, const SheetMesh& mesh, std::span<const grid::Field* const> fields,
                  int component, RawVector<double>& values)
{
	UnionFind one(mesh.positions.size());
	for (const auto& [v, w] : mesh.seam_pairs)
		if (isSameValue(values[v], values[w],
		                std::max(vertexScale(blocks, mesh, v, fields, component),
		                         vertexScale(blocks, mesh, w, fields, component))))
			one.join(v, w);
	for (const auto& [v, w] : mesh.seam_pairs)
	{
		values[v] = values[one.root(v)];
		values[w] = values[one.root(w)];
	}
}

} // namespace

double interpolate(const grid::Block& block, const grid::Field& field, int component, const EdgePoint& at)
{
	const auto sources = std::visit(
	    [&](const auto& grid) {
		    return std::pair{grid.sourcePoint(at.lower), grid.sourcePoint(at.higher)};
	    },
	    block.grid);
	return grid::shownValue(
	    field.components, component,
	    [&](int c)
	    { return alongEdge(field.value(sources.first, c), field.value(sources.second, c), at.t, field.categorical); });
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

double vertexScale(const grid::BlockSet& blocks, const SheetMesh& mesh, std::size_t vertex,
                   std::span<const grid::Field* const> fields, int component)
{
	double scale = 0.0;
	const auto include = [&](std::uint32_t block, PointId point)
	{
		const grid::Field* field = fields[block];
		if (!field || field->categorical || component >= field->components)
			return;
		const auto source = std::visit([&](const auto& grid) { return std::size_t(grid.sourcePoint(point)); },
		                               blocks.blocks[block].grid);
		scale = std::max(scale, std::abs(grid::shownValue(*field, source, component)));
	};
	if (vertex < mesh.edges.size())
	{
		include(mesh.edges[vertex].block, mesh.edges[vertex].lower);
		include(mesh.edges[vertex].block, mesh.edges[vertex].higher);
	}
	else
		for (const PointShare& share : mesh.rimShares(vertex))
			include(share.block, share.point);
	return scale;
}

RawVector<double> vertexValues(const grid::BlockSet& blocks, const SheetMesh& mesh,
                               std::span<const grid::Field* const> fields, int component)
{
	fetchValues(blocks, mesh, fields);
	RawVector<double> values;
	values.resize(mesh.positions.size());
	constexpr std::size_t kGrain = 4096;
	const auto fill = [&](const tbb::blocked_range<std::size_t>& part)
	{
		for (std::size_t v = part.begin(); v < part.end();)
		{
			const std::size_t on_edges = std::min(part.end(), mesh.edges.size());
			std::size_t end = v + 1;
			const grid::Field* field = v < on_edges ? fields[mesh.edges[v].block] : nullptr;
			if (!field || component < 0 || component >= field->components)
				values[v] = vertexValue(blocks, mesh, v, fields, component);
			else
			{
				const std::uint32_t block = mesh.edges[v].block;
				if (blocks.blocks.size() == 1)
					end = on_edges; // a pass over all edges costs a fifth of the values
				while (end < on_edges && mesh.edges[end].block == block)
					++end;
				interpolateAll(blocks.blocks[block], *field, component, std::span(mesh.edges).subspan(v, end - v),
				               &values[v]);
			}
			v = end;
		}
	};
	tracedFor(tbb::blocked_range<std::size_t>(0, values.size(), kGrain), fill);
	if (!mesh.seam_pairs.empty())
		uniteAtSeams(blocks, mesh, fields, component, values);
	return values;
}

double cellValue(const grid::Block& block, const grid::Field& field, int component, CellId cell)
{
	const std::size_t source =
	    std::visit([&](const auto& grid) { return std::size_t(grid.sourceCell(cell)); }, block.grid);
	return grid::shownValue(field, source, component);
}

std::vector<double> polygonValues(const grid::BlockSet& blocks, const SheetMesh& mesh,
                                  std::span<const grid::Field* const> fields, int component)
{
	fetchValues(blocks, mesh, fields);
	std::vector<double> values;
	values.reserve(mesh.polygons());
	for (const auto& [b, cell] : mesh.polygon_cells)
		values.push_back(fields[b] ? cellValue(blocks.blocks[b], *fields[b], component, cell)
		                           : std::numeric_limits<double>::quiet_NaN());
	return values;
}

} // namespace vp::mesh
