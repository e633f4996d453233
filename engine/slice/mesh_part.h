#pragma once

#include "grid/record_reader.h"
#include "slice/cell_polygons.h"
#include "slice/edge_numbers.h"
#include "traverse/bfs.h"

#include <type_traits>
#include <utility>

namespace vp::slice
{

// The polygons of some of a block's cut cells, with vertices of their own: few enough to stay in a core's cache while
// they are made.
struct MeshPart
{
	RawVector<std::uint64_t> edges;    // per vertex, in the order in which the cells first meet them
	RawVector<std::uint32_t> corners;  // of all polygons: vertices of the part
	RawVector<std::uint32_t> ends;     // per polygon: one past its last corner
	RawVector<CellId> cells;           // per polygon
	std::vector<std::uint32_t> shared; // the vertices that other parts may have too, ascending
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
// In a closed cut it is enough to hold that cell's number against the part's first and last.
template <grid::Grid G, class Reader>
class MeshPartMaker
{
public:
	MeshPartMaker(const G& grid, const Reader& reader, const surface::Plane& plane, const traverse::LaneCut& cut,
	              std::size_t begin, std::size_t end)
	    : reader_(reader), cut_(cut), begin_(begin), end_(end), first_cell_(cut.cells[begin]),
	      cell_span_(cut.closed ? cut.cells[end - 1] - first_cell_ + 1 : 0), polygons_(grid, plane),
	      numbers_(end - begin)
	{
	}

	MeshPart make()
	{
		part_.ends.reserve(end_ - begin_);
		part_.cells.reserve(end_ - begin_);
		for (std::size_t i = begin_; i < end_; ++i)
		{
			if constexpr (kReadsRecords)
				if (i + kAhead < end_)
					reader_.prefetchCell(cut_.cells[i + kAhead]);
			if (!(cut_.words[i] & shared::kWordCut))
				continue;
			if (const cases::Case* entry = polygons_.entryOf(cut_.cells[i], cut_.words[i]))
				addByTable(cut_.cells[i], *entry);
			else
				addByWalk(cut_.cells[i], cut_.words[i]);
		}
		part_.corners.resize(corners_);
		part_.edges = numbers_.takeEdges();
		for (std::uint32_t v = 0; v < part_.edges.size(); ++v)
			if (is_shared_[v])
				part_.shared.push_back(v);
		return std::move(part_);
	}

private:
	static constexpr bool kReadsRecords = !std::is_same_v<Reader, CellReader<G>>;
	static constexpr std::size_t kAhead = 16; // cells

	// For the corners of one polygon, whose edges may all be new.
	void makeRoom(std::size_t corners)
	{
		numbers_.makeRoom(corners);
		if (const std::size_t room = numbers_.size() + corners; room > is_shared_.size())
			is_shared_.resize(room + room / 2 + (end_ - begin_));
		if (const std::size_t room = corners_ + corners; room > part_.corners.size())
			part_.corners.resize(room + room / 2 + 4 * (end_ - begin_));
	}

	void addByTable(CellId cell, const cases::Case& entry)
	{
		makeRoom(cases::kMaxPolygon);
		const auto record = reader_.record(cell);
		std::uint32_t* corners = &part_.corners[corners_];
		{
			EdgeNumbers::Search search(numbers_);
			for (int e = 0; e < entry.edges; ++e)
				corners[e] = find(search, record[entry.edge[e][0]], record[entry.edge[e][1]]);
		}
		if constexpr (kReadsRecords)
			for (int e = 0; e < entry.edges; ++e)
				if (reader_.across(record)[entry.face_after[e]] - first_cell_ >= cell_span_)
				{
					is_shared_[corners[e]] = true;
					is_shared_[corners[e + 1 < entry.edges ? e + 1 : 0]] = true;
				}
		endPolygon(cell, entry.edges);
	}

	void addByWalk(CellId cell, std::uint32_t word)
	{
		const auto add = [&](std::span<const typename CellPolygons<G>::Edge> edges)
		{
			makeRoom(edges.size());
			EdgeNumbers::Search search(numbers_);
			std::uint32_t* corner = &part_.corners[corners_];
			for (const auto& [positive, negative] : edges)
			{
				*corner = find(search, positive, negative);
				is_shared_[*corner++] = true;
			}
			endPolygon(cell, edges.size());
		};
		part_.twisted += polygons_.visit(cell, word, add);
	}

	static std::uint32_t find(EdgeNumbers::Search& search, PointId a, PointId b)
	{
		return search.find(EdgeNumbers::keyOf(std::min(a, b), std::max(a, b)));
	}

	void endPolygon(CellId cell, std::size_t corners)
	{
		corners_ += static_cast<std::uint32_t>(corners);
		part_.ends.push_back(corners_);
		part_.cells.push_back(cell);
	}

	const Reader& reader_;
	const traverse::LaneCut& cut_;
	std::size_t begin_;
	std::size_t end_;
	CellId first_cell_;
	CellId cell_span_; // cells from first_cell_ on that are of this part, where they are cut
	CellPolygons<G> polygons_;
	EdgeNumbers numbers_;
	std::vector<std::uint8_t> is_shared_; // per vertex
	std::uint32_t corners_ = 0;
	MeshPart part_;
};

} // namespace vp::slice
