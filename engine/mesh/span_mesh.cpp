#include "mesh/span_mesh.h"

#include "base/parallel_for.h"
#include "mesh/cell_polygons.h"
#include "mesh/edge_places.h"
#include "mesh/span_polygons.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>

namespace vp::mesh
{

namespace
{

using cases::ColumnCase;
using find::Span;
using find::SpanCut;

template <class G>
class SpanMesh
{
public:
	// extent: of the grid's points.
	SpanMesh(const G& grid, const Vec3& extent, std::uint32_t block, const surface::Plane& plane, const Vec3& normal,
	         const SpanCut& cut, SheetMesh& mesh)
	    : grid_(grid), extent_(extent), block_(block), plane_(plane), normal_(normal), cut_(cut), mesh_(mesh),
	      points_(grid.points()), cells_(grid.cells()), strides_{1, points_[0], points_[0] * points_[1]},
	      first_vertex_(static_cast<std::uint32_t>(mesh.positions.size())),
	      first_polygon_(static_cast<std::uint32_t>(mesh.polygons())),
	      first_corner_(static_cast<std::uint32_t>(mesh.polygon_vertices.size()))
	{
	}

	MeshCleanup add()
	{
		if constexpr (!std::is_same_v<G, grid::CurvilinearGrid>)
			for (int axis = 0; axis < 3; ++axis)
				for (std::uint32_t i = 0; i < points_[axis]; ++i)
					coordinates_[axis].push_back(grid_.coordinate(axis, i));
		mesh_.positions.resize(first_vertex_ + cut_.counts.vertices);
		mesh_.edges.resize(first_vertex_ + cut_.counts.vertices);
		mesh_.polygon_starts.resize(first_polygon_ + cut_.counts.polygons + 1);
		mesh_.polygon_cells.resize(first_polygon_ + cut_.counts.polygons);
		mesh_.polygon_vertices.resize(first_corner_ + cut_.counts.corners);
		owned_.resize(cut_.columns.size());
		constexpr std::size_t kGrain = 1024; // spans
		const tbb::blocked_range<std::size_t> spans(0, cut_.spans.size(), kGrain);
		tracedFor(spans, [&](const auto& range) { addVertices(range.begin(), range.end()); });
		tracedFor(spans, [&](const auto& range) { addPolygons(range.begin(), range.end()); });
		if (cut_.cells.walked)
			addWalked();
		return {at_points_, slivers_ || cut_.cells.walked != 0};
	}

private:
	void addVertices(std::size_t begin, std::size_t end)
	{
		constexpr std::size_t kPart = 12; // spans, whose edges stay in a core's first cache until they are placed
		bool at_points = false;
		for (std::size_t from = begin; from < end; from += kPart)
		{
			const std::size_t to = std::min(from + kPart, end);
			for (std::size_t s = from; s < to; ++s)
			{
				prefetchRows(std::min(s + kAhead, end - 1));
				if (firstVertexOf(s + 1) == firstVertexOf(end))
					numberVertices<true>(cut_.spans[s]);
				else
					numberVertices<false>(cut_.spans[s]);
			}
			at_points |= placeVertices(from, to);
		}
		if (at_points)
			at_points_ = true;
	}

	std::uint32_t firstVertexOf(std::size_t span) const
	{
		return first_vertex_ + (span < cut_.spans.size() ? cut_.spans[span].counts.vertices : cut_.counts.vertices);
	}

	// Names the edges of the vertices that the points of a span own. Which of its three edges a point owns cannot be
	// foreseen. So all are written, and the next one begins behind those that count. kLast: the vertex behind the span
	// is another thread's, or none.
	template <bool kLast>
	void numberVertices(const Span& span)
	{
		const ColumnCase* columns = &cut_.columns[span.columns];
		const std::uint32_t length = span.end - span.begin;
		const OwnedEdges* owned_by = owned_by_.data();
		const std::uint32_t first = first_vertex_ + span.counts.vertices;
		FourNumbers next{first, first, first, first};
		OwnedVertices* numbers = &owned_[span.columns];
		auto* edge = reinterpret_cast<std::byte*>(mesh_.edges.data() + first);
		const PointId p = span.row * points_[0] + span.begin;
		FourNumbers name[3]; // what an EdgePoint begins with, and the gap before its t
		for (unsigned axis = 0; axis < 3; ++axis)
			name[axis] = FourNumbers{block_, p, p + strides_[axis], 0};
		for (std::uint32_t x = 0; x <= length; ++x)
		{
			const OwnedEdges& owned = owned_by[columns[x]];
			const FourNumbers along = next + owned.up_to;
			std::memcpy(&numbers[x], &along, sizeof(along));
			next += __builtin_shufflevector(owned.up_to, owned.up_to, 3, 3, 3, 3);
			for (unsigned axis = 0; axis < 3; ++axis)
			{
				if (!kLast || owned.bytes[axis + 1] != owned.bytes[axis])
					std::memcpy(edge + owned.bytes[axis], &name[axis], sizeof(name[axis]));
				name[axis] += FourNumbers{0, 1, 1, 0};
			}
			edge += owned.bytes[3];
		}
	}
	static_assert(offsetof(EdgePoint, block) == 0 && offsetof(EdgePoint, lower) == 4 &&
	              offsetof(EdgePoint, higher) == 8 && offsetof(EdgePoint, t) == sizeof(FourNumbers));

	// Finds where the vertices of spans lie on their edges. Returns whether one is at a grid point.
	bool placeVertices(std::size_t from, std::size_t to)
	{
		if constexpr (std::is_same_v<G, grid::CurvilinearGrid>)
			return grid_.coordinates().isDouble() ? placeAmongPoints<double>(from, to)
			                                      : placeAmongPoints<float>(from, to);
		bool at_points = false;
		for (std::size_t s = from; s < to; ++s)
			at_points |= placeOnAxes(s);
		return at_points;
	}

	template <class Number>
	bool placeAmongPoints(std::size_t from, std::size_t to)
	{
		const Number* xyz = grid_.coordinates().template numbers<Number>();
		return placeVertices(firstVertexOf(from), firstVertexOf(to),
		                     [=](const EdgePoint& edge) { return edgeEnds(xyz, edge.lower, edge.higher); });
	}

	// Places a span's vertices in a grid with straight axes, where points have the coordinates of their rows.
	bool placeOnAxes(std::size_t span)
	{
		const std::uint32_t row = cut_.spans[span].row;
		const std::uint32_t k = row / points_[1];
		const double* x = coordinates_[0].data();
		const double* y = coordinates_[1].data() + (row - k * points_[1]);
		const double* z = coordinates_[2].data() + k;
		const PointId first = row * points_[0];
		const std::uint32_t layer = strides_[2];
		return placeVertices(
		    firstVertexOf(span), firstVertexOf(span + 1),
		    [=](const EdgePoint& edge)
		    {
			    const std::uint32_t step = edge.higher - edge.lower;
			    const std::uint32_t i = edge.lower - first;
			    const bool along_i = step == 1;
			    const bool along_k = step == layer;
			    return EdgeEnds{{x[i], *y}, {x[i + along_i], y[!along_i && !along_k]}, {*z, z[along_k]}};
		    });
	}

	// Places the vertices [begin, end).
	template <class EndsOf>
	bool placeVertices(std::uint32_t begin, std::uint32_t end, EndsOf endsOf)
	{
		EdgePoint* edges = mesh_.edges.data() + begin;
		Vec3* positions = mesh_.positions.data() + begin;
		return EdgePlaces<PlacedFrom::lower>(plane_).place(
		    end - begin, [=](std::size_t v) { return endsOf(edges[v]); },
		    [=](std::size_t v, double t, TwoDoubles xy, double z)
		    {
			    edges[v].t = t;
			    storeTwo(&positions[v].x, xy);
			    positions[v].z = z;
		    });
	}

	void prefetchRows(std::size_t s) const
	{
		if constexpr (requires { grid_.prefetch(PointId{}, PointId{}); })
		{
			const Span& span = cut_.spans[s];
			const PointId p = span.row * points_[0] + span.begin;
			const PointId length = span.end - span.begin;
			for (const PointId row : {p, p + strides_[1], p + strides_[2]})
				grid_.prefetch(row, row + length);
		}
	}

	// The spans of a row beside the one at hand, as that moves on.
	struct Beside
	{
		std::size_t at;

		// Returns where the vertices of the row's points are for column i, as an index into owned_. The result holds
		// for columns from i up to `stop`, which is lowered to the begin of the row's next span. The current span is
		// the row's first one that ends behind i, since cells have no corners in this row before its begin or behind
		// its end.
		std::ptrdiff_t from(const SpanMesh& mesh, std::uint32_t row, std::uint32_t i, std::uint32_t& stop)
		{
			const Span* spans = mesh.cut_.spans.data();
			const std::size_t count = mesh.cut_.spans.size();
			while (at < count && (spans[at].row < row || (spans[at].row == row && spans[at].end <= i)))
				++at;
			if (at == count || spans[at].row != row)
				return 0;
			if (at + 1 < count && spans[at + 1].row == row)
				stop = std::min(stop, spans[at + 1].begin);
			return 4 * (std::ptrdiff_t(spans[at].columns) + i - spans[at].begin);
		}
	};

	void addPolygons(std::size_t begin, std::size_t end)
	{
		const std::uint32_t steps[3] = {1, points_[1], points_[1] + 1};
		Beside beside[3];
		for (int r = 0; r < 3; ++r)
			beside[r].at = static_cast<std::size_t>(
			    std::ranges::lower_bound(cut_.spans, cut_.spans[begin].row + steps[r], {}, &Span::row) -
			    cut_.spans.begin());
		SpanPolygonWriter writer({cut_, owned_.data(), block_, first_polygon_, first_corner_},
		                         FanSense<cases::kMaxLatticeEdges>(normal_, extent_, mesh_.positions.data()), end,
		                         mesh_);
		std::uint32_t k = cut_.spans[begin].row / points_[1];
		for (std::size_t s = begin; s < end; ++s)
		{
			const Span& span = cut_.spans[s];
			while (span.row - k * points_[1] >= points_[1]) // rows ascend
				++k;
			const std::uint32_t j = span.row - k * points_[1];
			if (j >= cells_[1] || k >= cells_[2])
				continue;
			writer.startSpan(s, grid_.cell(span.begin, j, k));
			for (std::uint32_t i = span.begin; i < span.end;)
			{
				std::uint32_t stop = span.end;
				std::ptrdiff_t rows[4] = {4 * (std::ptrdiff_t(span.columns) + i - span.begin)};
				for (int r = 0; r < 3; ++r)
					rows[r + 1] = beside[r].from(*this, span.row + steps[r], i, stop);
				writer.add(stop - i, rows);
				i = stop;
			}
		}
		if (writer.hasSlivers())
			slivers_ = true;
	}

	// The cells that the table has no entry for, behind all others.
	void addWalked()
	{
		CellPolygons polygons(grid_, plane_);
		for (const Span& span : cut_.spans)
		{
			const std::uint32_t k = span.row / points_[1];
			const std::uint32_t j = span.row - k * points_[1];
			if (j >= cells_[1] || k >= cells_[2])
				continue;
			const ColumnCase* columns = &cut_.columns[span.columns];
			for (std::uint32_t x = 0; x < span.end - span.begin; ++x)
				if (!(columns[x] & cases::kLeftOut) && cases::latticeCases()[columns[x]].needs_walk)
					addWalkedCell(polygons, grid_.cell(span.begin + x, j, k));
		}
	}
	void addWalkedCell(CellPolygons<G, surface::Plane>& polygons, CellId cell)
	{
		const std::uint32_t code = find::classifyByTable(grid_, plane_, cell, grid::CellShape::hexahedron);
		mesh_.cells_twisted += polygons.visit(cell, code,
		                                      [&](const auto& edges)
		                                      {
			                                      for (const auto& edge : edges)
				                                      mesh_.polygon_vertices.push_back(vertexOf(edge));
			                                      mesh_.polygon_starts.push_back(
			                                          static_cast<std::uint32_t>(mesh_.polygon_vertices.size()));
			                                      mesh_.polygon_cells.push_back({block_, cell});
		                                      });
	}
	std::uint32_t vertexOf(std::pair<PointId, PointId> edge) const
	{
		const auto [lower, higher] = std::minmax(edge.first, edge.second);
		const std::uint32_t row = lower / points_[0];
		const std::uint32_t i = lower - row * points_[0];
		// The last span of the row that begins at i or before.
		const auto after = std::ranges::upper_bound(cut_.spans, std::pair(row, i), {},
		                                            [](const Span& s) { return std::pair(s.row, s.begin); });
		const Span& span = *std::prev(after);
		const std::uint32_t stride = higher - lower;
		const unsigned axis = stride == strides_[2] ? 2 : stride == strides_[1] ? 1 : 0;
		return owned_[span.columns + (i - span.begin)].along[axis];
	}

	static constexpr std::size_t kAhead = 8; // spans, whose points are fetched in advance

	const G& grid_;
	const Vec3 extent_;
	std::uint32_t block_;
	const surface::Plane& plane_;
	const Vec3 normal_;
	const SpanCut& cut_;
	SheetMesh& mesh_;
	const OwnedTable& owned_by_ = ownedTable();
	std::array<std::uint32_t, 3> points_;
	std::array<std::uint32_t, 3> cells_;
	std::array<std::uint32_t, 3> strides_;
	std::uint32_t first_vertex_;
	std::uint32_t first_polygon_;
	std::uint32_t first_corner_;
	RawVector<OwnedVertices> owned_;                 // per column
	std::array<std::vector<double>, 3> coordinates_; // per axis, of a grid with straight ones
	std::atomic<bool> at_points_{false};
	std::atomic<bool> slivers_{false};
};

} // namespace

MeshCleanup addSpans(const grid::Block& block, std::uint32_t number, const surface::Plane& plane, const Vec3& normal,
                     const find::SpanCut& cut, SheetMesh& mesh)
{
	if (cut.spans.empty())
		return {};
	return std::visit(
	    [&](const auto& grid) -> MeshCleanup
	    {
		    using G = std::decay_t<decltype(grid)>;
		    if constexpr (std::is_base_of_v<grid::Lattice, G>)
			    return SpanMesh<G>(grid, block.bounds.size(), number, plane, normal, cut, mesh).add();
		    else
			    return {};
	    },
	    block.grid);
}

} // namespace vp::mesh
