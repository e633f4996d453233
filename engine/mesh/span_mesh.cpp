#include "mesh/span_mesh.h"

#include "mesh/cell_polygons.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace vp::mesh
{

namespace
{

using cases::Column;
using cases::LatticeCase;
using cases::LatticeEdge;
using find::Span;
using find::SpanCut;

// The numbers of the up to three vertices that a point owns, along i, j and k. A vertex that is not there has the
// number of the next one.
struct OwnedVertices
{
	OwnedVertices() = default;
	OwnedVertices(std::uint32_t first, unsigned owned)
	    : along{first, first + (owned & 1), first + (owned & 1) + (owned >> 1 & 1), 0}
	{
	}

	std::uint32_t along[4]; // the fourth is not used: a power of two is found by a shift
};

// Where the corners of a cell's polygon stand: in the vertices of one of the four rows of points along the cell,
// counted from the column where the cell begins.
struct CornerPlaces
{
	std::array<std::uint8_t, cases::kMaxLatticeEdges> row;
	std::array<std::uint8_t, cases::kMaxLatticeEdges> number;
	std::uint8_t corners; // 0: the cell has no polygon by the table
};

const std::array<CornerPlaces, 256>& cornerPlaces()
{
	static const std::array<CornerPlaces, 256> table = []
	{
		std::array<CornerPlaces, 256> made{};
		for (std::size_t c = 0; c < made.size(); ++c)
		{
			const LatticeCase& entry = cases::latticeCases()[c];
			made[c].corners = entry.edges;
			for (std::size_t e = 0; e < entry.edge.size(); ++e)
			{
				made[c].row[e] = entry.edge[e].row;
				made[c].number[e] = static_cast<std::uint8_t>(4 * entry.edge[e].at + entry.edge[e].axis);
			}
		}
		return made;
	}();
	return table;
}

template <class G>
class SpanMesh
{
public:
	SpanMesh(const G& grid, std::uint32_t block, const surface::Plane& plane, const Vec3& normal, const SpanCut& cut,
	         SheetMesh& mesh)
	    : grid_(grid), block_(block), plane_(plane), normal_(normal), cut_(cut), mesh_(mesh), points_(grid.points()),
	      cells_(grid.cells()), strides_{1, points_[0], points_[0] * points_[1]},
	      first_vertex_(static_cast<std::uint32_t>(mesh.positions.size())),
	      first_polygon_(static_cast<std::uint32_t>(mesh.polygons())),
	      first_corner_(static_cast<std::uint32_t>(mesh.polygon_vertices.size()))
	{
	}

	MeshCleanup add()
	{
		mesh_.positions.resize(first_vertex_ + cut_.counts.vertices);
		mesh_.edges.resize(first_vertex_ + cut_.counts.vertices);
		mesh_.polygon_starts.resize(first_polygon_ + cut_.counts.polygons + 1);
		mesh_.polygon_cells.resize(first_polygon_ + cut_.counts.polygons);
		mesh_.polygon_vertices.resize(first_corner_ + cut_.counts.corners);
		owned_.resize(cut_.columns.size());
		constexpr std::size_t kGrain = 1024; // spans
		const tbb::blocked_range<std::size_t> spans(0, cut_.spans.size(), kGrain);
		tbb::parallel_for(spans, [&](const auto& range) { addVertices(range.begin(), range.end()); });
		tbb::parallel_for(spans, [&](const auto& range) { addPolygons(range.begin(), range.end()); });
		if (cut_.cells.walked)
			addWalked();
		return {at_points_, slivers_ || cut_.cells.walked != 0};
	}

private:
	unsigned ownedAt(const Column* columns, std::uint32_t x, std::uint32_t last) const
	{
		return table_[cases::caseIndex(columns[x], columns[std::min(x + 1, last)])].owned;
	}

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
				numberVertices(cut_.spans[s], firstVertexOf(s + 1) == firstVertexOf(end));
			}
			if constexpr (std::is_same_v<G, grid::CurvilinearGrid>)
				at_points |=
				    placeVertices(firstVertexOf(from), firstVertexOf(to), [&](PointId p) { return grid_.point(p); });
			else
				for (std::size_t s = from; s < to; ++s)
					at_points |= placeVertices(firstVertexOf(s), firstVertexOf(s + 1), pointsAlong(cut_.spans[s]));
		}
		if (at_points)
			at_points_ = true;
	}

	std::uint32_t firstVertexOf(std::size_t span) const
	{
		return first_vertex_ + (span < cut_.spans.size() ? cut_.spans[span].counts.vertices : cut_.counts.vertices);
	}

	// Names the edges of the vertices that the points of a span own. Which of its three edges a point owns cannot be
	// foreseen. So all are written, and the next one begins behind those that count; `last`: the vertex behind the span
	// is another thread's, or none.
	void numberVertices(const Span& span, bool last)
	{
		std::uint32_t next = first_vertex_ + span.counts.vertices;
		const Column* columns = &cut_.columns[span.columns];
		const std::uint32_t length = span.end - span.begin;
		PointId p = span.row * points_[0] + span.begin;
		for (std::uint32_t x = 0; x <= length; ++x, ++p)
		{
			const unsigned owned = ownedAt(columns, x, length);
			const OwnedVertices vertices(next, owned);
			owned_[span.columns + x] = vertices;
			for (unsigned axis = 0; axis < 3; ++axis)
			{
				if (last && !(owned >> axis & 1))
					continue;
				EdgePoint& edge = mesh_.edges[vertices.along[axis]];
				edge.block = block_;
				edge.lower = p;
				edge.higher = p + strides_[axis];
			}
			next = vertices.along[2] + (owned >> 2);
		}
	}

	// Finds where the vertices [begin, end) lie on their edges. Returns whether one is at a grid point.
	template <class PointAt>
	bool placeVertices(std::uint32_t begin, std::uint32_t end, PointAt&& point_at)
	{
		const surface::Plane plane = plane_; // a copy: what is written cannot be thought to change it
		bool at_points = false;
		for (std::uint32_t v = begin; v < end; ++v)
		{
			EdgePoint& edge = mesh_.edges[v];
			const Vec3 a = point_at(edge.lower);
			const Vec3 b = point_at(edge.higher);
			const double t = surface::Plane::crossing(plane.signedDistance(a), plane.signedDistance(b));
			edge.t = t;
			mesh_.positions[v] = placeOnEdge(a, b, t);
			at_points |= (t == 0.0) | (t == 1.0);
		}
		return at_points;
	}

	// The points of a span's edges, without a division for each.
	auto pointsAlong(const Span& span) const
	{
		const std::uint32_t k = span.row / points_[1];
		const std::uint32_t j = span.row - k * points_[1];
		const PointId row = span.row * points_[0];
		return [this, j, k, row](PointId p)
		{
			const PointId from = p - row;
			if (from < points_[0])
				return grid_.pointAt(from, j, k);
			return from >= strides_[2] ? grid_.pointAt(from - strides_[2], j, k + 1)
			                           : grid_.pointAt(from - strides_[1], j + 1, k);
		};
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

		// The vertices that the points of the row own, from the cell i on; null if the row has none there. That holds
		// up to the cell `stop`, which is lowered where needed.
		const std::uint32_t* from(const SpanMesh& mesh, std::uint32_t row, std::uint32_t i, std::uint32_t& stop)
		{
			const RawVector<Span>& spans = mesh.cut_.spans;
			while (at < spans.size() && (spans[at].row < row || (spans[at].row == row && spans[at].end <= i)))
				++at;
			if (at == spans.size() || spans[at].row != row || spans[at].begin >= stop)
				return nullptr;
			if (spans[at].begin > i)
			{
				stop = spans[at].begin;
				return nullptr;
			}
			stop = std::min(stop, spans[at].end);
			return mesh.owned_[spans[at].columns + (i - spans[at].begin)].along;
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
		const std::uint32_t last_corner =
		    first_corner_ + (end < cut_.spans.size() ? cut_.spans[end].counts.corners : cut_.counts.corners);
		const Facing facing(normal_);
		bool slivers = false;
		for (std::size_t s = begin; s < end; ++s)
		{
			const Span& span = cut_.spans[s];
			const std::uint32_t k = span.row / points_[1];
			const std::uint32_t j = span.row - k * points_[1];
			if (j >= cells_[1] || k >= cells_[2])
				continue;
			std::uint32_t polygon = first_polygon_ + span.counts.polygons;
			std::uint32_t corner = first_corner_ + span.counts.corners;
			CellId cell = grid_.cell(span.begin, j, k);
			const Column* columns = &cut_.columns[span.columns];
			const std::uint32_t* own = owned_[span.columns].along;
			for (std::uint32_t i = span.begin; i < span.end;)
			{
				std::uint32_t stop = span.end;
				const std::uint32_t* rows[4] = {own};
				for (int r = 0; r < 3; ++r)
				{
					// A cell has no corners in a row without vertices.
					const std::uint32_t* found = beside[r].from(*this, span.row + steps[r], i, stop);
					rows[r + 1] = found ? found : own;
				}
				own += 4 * (stop - i);
				for (std::size_t column = 0; i < stop; ++i, ++cell, ++columns, column += 4)
				{
					const CornerPlaces& places = places_[cases::caseIndex(columns[0], columns[1])];
					if (!places.corners || (columns[0] & cases::kLeftOut))
						continue;
					std::uint32_t corners[cases::kMaxLatticeEdges];
					for (int e = 0; e < cases::kMaxLatticeEdges; ++e)
						corners[e] = rows[places.row[e]][column + places.number[e]];
					slivers |= !facing.turnFan(mesh_.positions.data(), corners, places.corners);
					// What is written behind a polygon belongs to the next one.
					std::uint32_t* to = &mesh_.polygon_vertices[corner];
					if (corner + cases::kMaxLatticeEdges <= last_corner)
						std::copy_n(corners, cases::kMaxLatticeEdges, to);
					else
						std::copy_n(corners, places.corners, to);
					mesh_.polygon_cells[polygon] = {block_, cell};
					corner += places.corners;
					mesh_.polygon_starts[++polygon] = corner;
				}
			}
		}
		if (slivers)
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
			const Column* columns = &cut_.columns[span.columns];
			for (std::uint32_t x = 0; x < span.end - span.begin; ++x)
				if (table_[cases::caseIndex(columns[x], columns[x + 1])].needs_walk && !(columns[x] & cases::kLeftOut))
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
	std::uint32_t block_;
	const surface::Plane& plane_;
	const Vec3 normal_;
	const SpanCut& cut_;
	SheetMesh& mesh_;
	std::array<std::uint32_t, 3> points_;
	std::array<std::uint32_t, 3> cells_;
	std::array<std::uint32_t, 3> strides_;
	const std::array<LatticeCase, 256>& table_ = cases::latticeCases();
	const std::array<CornerPlaces, 256>& places_ = cornerPlaces();
	std::uint32_t first_vertex_;
	std::uint32_t first_polygon_;
	std::uint32_t first_corner_;
	RawVector<OwnedVertices> owned_; // per column
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
			    return SpanMesh<G>(grid, number, plane, normal, cut, mesh).add();
		    else
			    return {};
	    },
	    block.grid);
}

} // namespace vp::mesh
