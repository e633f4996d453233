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

// The numbers of the up to three vertices that a point owns: that of the first, and two bits that tell whether it has
// one along i and one along j.
class OwnedVertices
{
public:
	OwnedVertices() = default;
	OwnedVertices(std::uint32_t first, unsigned owned) : packed_(first << 2 | (owned & 3)) {}

	std::uint32_t along(unsigned axis) const
	{
		constexpr std::uint32_t kBefore[3] = {0, 1, 3};
		const std::uint32_t before = packed_ & kBefore[axis];
		return (packed_ >> 2) + (before & 1) + (before >> 1);
	}

private:
	std::uint32_t packed_;
};

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
		bool at_points = false;
		for (std::size_t s = begin; s < end; ++s)
		{
			const Span& span = cut_.spans[s];
			prefetchRows(std::min(s + kAhead, end - 1));
			std::uint32_t next = first_vertex_ + span.counts.vertices;
			const Column* columns = &cut_.columns[span.columns];
			const std::uint32_t last = span.end - span.begin;
			const std::uint32_t k = span.row / points_[1];
			const std::uint32_t j = span.row - k * points_[1];
			PointId p = span.row * points_[0] + span.begin;
			for (std::uint32_t x = 0; x <= last; ++x, ++p)
			{
				const unsigned owned = ownedAt(columns, x, last);
				owned_[span.columns + x] = OwnedVertices(next, owned);
				if (!owned)
					continue;
				const std::uint32_t i = span.begin + x;
				const Vec3 a = grid_.pointAt(i, j, k);
				const double da = plane_.signedDistance(a);
				for (int axis = 0; axis < 3; ++axis)
				{
					if (!(owned >> axis & 1))
						continue;
					const PointId higher = p + strides_[axis];
					const Vec3 b = grid_.pointAt(i + (axis == 0), j + (axis == 1), k + (axis == 2));
					const double t = surface::Plane::crossing(da, plane_.signedDistance(b));
					mesh_.edges[next] = {block_, p, higher, t};
					mesh_.positions[next] = placeOnEdge(a, b, t);
					at_points = at_points || t == 0.0 || t == 1.0;
					++next;
				}
			}
		}
		if (at_points)
			at_points_ = true;
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

		// The owned vertices from column i on; of a span that does not hold the cell i nothing is asked.
		const OwnedVertices* from(const SpanMesh& mesh, std::uint32_t row, std::uint32_t i)
		{
			const std::vector<Span>& spans = mesh.cut_.spans;
			while (at < spans.size() && (spans[at].row < row || (spans[at].row == row && spans[at].end <= i)))
				++at;
			if (at == spans.size() || spans[at].row != row || spans[at].begin > i)
				return kNone.data();
			return &mesh.owned_[spans[at].columns + (i - spans[at].begin)];
		}
	};

	void addPolygons(std::size_t begin, std::size_t end)
	{
		bool slivers = false;
		const std::uint32_t steps[3] = {1, points_[1], points_[1] + 1};
		Beside beside[3];
		for (int r = 0; r < 3; ++r)
			beside[r].at = static_cast<std::size_t>(
			    std::ranges::lower_bound(cut_.spans, cut_.spans[begin].row + steps[r], {}, &Span::row) -
			    cut_.spans.begin());
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
			const OwnedVertices* rows[4] = {&owned_[span.columns]};
			const Column* columns = &cut_.columns[span.columns];
			for (std::uint32_t i = span.begin; i < span.end; ++i, ++cell, ++columns, ++rows[0])
			{
				const LatticeCase& entry = table_[cases::caseIndex(columns[0], columns[1])];
				if (!entry.edges || (columns[0] & cases::kLeftOut))
					continue;
				for (int r = 0; r < 3; ++r)
					rows[r + 1] = beside[r].from(*this, span.row + steps[r], i);
				std::uint32_t* corners = &mesh_.polygon_vertices[corner];
				for (int e = 0; e < entry.edges; ++e)
				{
					const LatticeEdge& edge = entry.edge[e];
					corners[e] = rows[edge.row][edge.at].along(edge.axis);
				}
				slivers = !turnPolygon(mesh_, normal_, {corners, entry.edges}) || slivers;
				mesh_.polygon_cells[polygon] = {block_, cell};
				corner += entry.edges;
				mesh_.polygon_starts[++polygon] = corner;
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
		return owned_[span.columns + (i - span.begin)].along(axis);
	}

	static constexpr std::size_t kAhead = 8; // spans, whose points are fetched in advance
	static inline const std::array<OwnedVertices, 2> kNone{};

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
