#pragma once

#include "find/generations.h"
#include "grid/record_reader.h"
#include "mesh/cell_polygons.h"
#include "mesh/edge_numbers.h"
#include "mesh/open_vertices.h"

#include <type_traits>
#include <utility>

namespace vp::mesh
{

// The polygons of some of a block's cut cells, with vertices of their own: few enough to stay in a core's cache while
// they are made.
struct MeshChunk
{
	RawVector<std::uint64_t> edges;   // per vertex, in the order in which the cells first meet them
	RawVector<std::uint32_t> corners; // corners of all polygons, as vertices of the part
	RawVector<std::uint32_t> ends;    // per polygon: one past its last corner
	RawVector<CellId> cells;          // per polygon
	RawVector<std::uint32_t> shared;  // the vertices that other parts may have too, ascending
	std::size_t twisted = 0;

	// Once the parts know of each other: where they go in the mesh.
	std::vector<std::pair<std::uint32_t, std::uint32_t>> foreign; // vertices of an earlier part: here, and in the mesh
	std::uint32_t first_vertex = 0;
	std::uint32_t first_corner = 0;
	std::uint32_t first_polygon = 0;

	std::size_t owned() const { return edges.size() - foreign.size(); }
};

// How cells of any grid are read; of an unstructured one grid::RecordReader does it.
template <grid::Grid G>
class CellReader
{
public:
	static constexpr bool kTetrahedra = false; // alone

	explicit CellReader(const G& grid) : grid_(grid) {}

	std::array<PointId, grid::kMaxShapePoints> record(CellId c) const { return grid_.cellPoints(c).id; }
	Vec3 point(PointId p) const { return grid_.point(p); }

private:
	const G& grid_;
};

// Makes the part of the cells [begin, end) of a cut.
//
// An edge that other parts may know is found without asking them. The cells about an edge go on from each other through
// its cut faces, so where some of them are elsewhere, one here has a face with the edge whose other side is not here.
// In a closed cut it is enough to hold that cell's number against the part's first and last. Where no records are read,
// the polygons tell: around an edge of cells that are all here they close a ring.
template <grid::Grid G, class Reader, class Surface>
class MeshChunkBuilder
{
public:
	MeshChunkBuilder(const G& grid, const Reader& reader, const Surface& surface, const find::CellCut& cut,
	                 std::size_t begin, std::size_t end)
	    : reader_(reader), cut_(cut), begin_(begin), end_(end), first_cell_(cut.cells[begin]),
	      cell_span_(cut.closed ? cut.cells[end - 1] - first_cell_ + 1 : 0), polygons_(grid, surface)
	{
	}

	MeshChunk make()
	{
		for (std::size_t i = begin_; i < end_; ++i)
		{
			if constexpr (kReadsRecords)
				if (i + kAhead < end_)
					reader_.prefetchCell(cut_.cells[i + kAhead]);
			if (!(cut_.codes[i] & shared::kCodeCut))
				continue;
			if (const cases::Case* entry = polygons_.entryOf(cut_.cells[i], cut_.codes[i]))
				addByTable(cut_.cells[i], *entry);
			else
				addByWalk(cut_.cells[i], cut_.codes[i]);
		}
		part_.ends.resize(polygon_count_);
		part_.cells.resize(polygon_count_);
		NumberedEdges numbered = numberEdges({edges_.data(), corner_count_});
		part_.edges = std::move(numbered.edges);
		part_.corners = std::move(numbered.numbers);
		listShared();
		return std::move(part_);
	}

private:
	static constexpr bool kReadsRecords = !std::is_same_v<Reader, CellReader<G>>;
	static constexpr std::size_t kAhead = 16; // cells

	// Room for a polygon.
	void makeRoom(std::size_t corners)
	{
		const std::size_t cells = end_ - begin_;
		if (const std::size_t room = corner_count_ + corners; room > edges_.size())
			edges_.resize(room + room / 2 + 4 * cells);
		if (polygon_count_ == part_.ends.size())
		{
			part_.ends.resize(2 * polygon_count_ + cells);
			part_.cells.resize(part_.ends.size());
		}
	}

	// All the places of the longest polygon are written, whatever its length: that cannot be foreseen either.
	void addByTable(CellId cell, const cases::Case& entry)
	{
		makeRoom(kMaxCorners);
		const auto record = reader_.record(cell);
		std::uint64_t* edges = &edges_[corner_count_];
		for (int e = 0; e < kMaxCorners; ++e)
			edges[e] = edgeKey(record[entry.edge[e][0]], record[entry.edge[e][1]]);
		if constexpr (kReadsRecords)
			if (leadsOut(record, entry))
				listCornersOut(record, entry);
		endPolygon(cell, entry.edges);
	}

	// Returns true if the cell across a face does not belong to this part.
	template <class Record>
	bool leadsOut(const Record& record, std::uint8_t face) const
	{
		return reader_.across(record)[face] - first_cell_ >= cell_span_;
	}
	template <class Record>
	bool leadsOut(const Record& record, const cases::Case& entry) const
	{
		bool out = false;
		for (int e = 0; e < kMaxCorners; ++e)
			out |= leadsOut(record, entry.face_after[e]);
		return out;
	}

	template <class Record>
	void listCornersOut(const Record& record, const cases::Case& entry)
	{
		const auto first = static_cast<std::uint32_t>(corner_count_);
		for (std::uint32_t e = 0; e < entry.edges; ++e)
			if (leadsOut(record, entry.face_after[e]))
			{
				shared_corners_.push_back(first + e);
				shared_corners_.push_back(first + (e + 1 < entry.edges ? e + 1 : 0));
			}
	}

	void addByWalk(CellId cell, std::uint32_t code)
	{
		const auto add = [&](std::span<const typename CellPolygons<G, Surface>::Edge> edges)
		{
			makeRoom(edges.size());
			for (std::size_t e = 0; e < edges.size(); ++e)
			{
				edges_[corner_count_ + e] = edgeKey(edges[e].first, edges[e].second);
				shared_corners_.push_back(static_cast<std::uint32_t>(corner_count_ + e));
			}
			endPolygon(cell, edges.size());
		};
		part_.twisted += polygons_.visit(cell, code, add);
	}

	void endPolygon(CellId cell, std::size_t corners)
	{
		corner_count_ += corners;
		part_.ends[polygon_count_] = static_cast<std::uint32_t>(corner_count_);
		part_.cells[polygon_count_++] = cell;
	}

	// Where no neighbors are known: the vertices around which polygons of this part do not close a ring.
	void listOpen()
	{
		OpenVertices open(part_.edges.size());
		std::uint32_t begin = 0;
		for (const std::uint32_t end : part_.ends)
		{
			for (std::uint32_t corner = begin; corner + 1 < end; ++corner)
				open.add(part_.corners[corner], part_.corners[corner + 1]);
			open.add(part_.corners[end - 1], part_.corners[begin]);
			begin = end;
		}
		for (std::uint32_t v = 0; v < part_.edges.size(); ++v)
			if (open.isOpen(v))
				part_.shared.push_back(v);
	}

	void listShared()
	{
		if constexpr (!kReadsRecords)
			return listOpen();
		std::vector<std::uint8_t> is_shared(part_.edges.size());
		for (const std::uint32_t corner : shared_corners_)
			is_shared[part_.corners[corner]] = 1;
		part_.shared.resize(shared_corners_.size());
		std::size_t count = 0;
		for (std::uint32_t v = 0; v < is_shared.size() && count < part_.shared.size(); ++v)
		{
			part_.shared[count] = v; // to stay, where it is
			count += is_shared[v];
		}
		part_.shared.resize(count);
	}

	// The largest number of corners of a polygon from the table.
	static constexpr int kMaxCorners = Reader::kTetrahedra ? 4 : cases::kMaxPolygon;

	const Reader& reader_;
	const find::CellCut& cut_;
	std::size_t begin_;
	std::size_t end_;
	CellId first_cell_;
	CellId cell_span_; // cells from first_cell_ on that are of this part, where they are cut
	CellPolygons<G, Surface> polygons_;
	RawVector<std::uint64_t> edges_; // per corner
	std::vector<std::uint32_t> shared_corners_;
	std::size_t corner_count_ = 0;
	std::size_t polygon_count_ = 0;
	MeshChunk part_;
};

} // namespace vp::mesh
