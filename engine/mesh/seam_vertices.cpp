#include "mesh/seam_vertices.h"

#include <algorithm>
#include <tuple>

namespace vp::mesh
{

namespace
{

struct CellPolygon
{
	BlockCell cell;
	std::size_t polygon;
};

bool before(const BlockCell& a, const BlockCell& b)
{
	return std::tie(a.block, a.cell) < std::tie(b.block, b.cell);
}

// A point of a face and where it lies.
struct Corner
{
	PointId id;
	Vec3 position;
};

class SeamVertices
{
public:
	SeamVertices(const grid::BlockSet& blocks, const grid::Interfaces& interfaces, const SheetMesh& mesh)
	    : blocks_(blocks), interfaces_(interfaces), mesh_(mesh)
	{
	}

	std::vector<VertexPair> pairs()
	{
		for (std::size_t p = 0; p < mesh_.polygons(); ++p)
			if (const grid::BlockSeams* seams = seamsOf(p);
			    seams && !seams->ofCell(mesh_.polygon_cells[p].cell).empty())
				at_seams_.push_back({mesh_.polygon_cells[p], p});
		std::ranges::stable_sort(at_seams_, before, &CellPolygon::cell);
		for (const CellPolygon& polygon : at_seams_)
			for (const grid::SeamLink& link : seamsOf(polygon.polygon)->ofCell(polygon.cell.cell))
				if (before(polygon.cell, {link.block, link.other}))
					addAcross(polygon, link);
		return std::move(pairs_);
	}

private:
	const grid::BlockSeams* seamsOf(std::size_t polygon) const
	{
		return interfaces_.of(mesh_.polygon_cells[polygon].block);
	}

	void addAcross(const CellPolygon& polygon, const grid::SeamLink& link)
	{
		const BlockCell other_cell{link.block, link.other};
		const std::span<const CellPolygon> others(
		    std::ranges::lower_bound(at_seams_, other_cell, before, &CellPolygon::cell),
		    std::ranges::upper_bound(at_seams_, other_cell, before, &CellPolygon::cell));
		if (others.empty())
			return;
		const std::vector<Corner> face = corners(polygon.cell.block, link.cell, link.face);
		const std::vector<Corner> other_face = corners(link.block, link.other, link.other_face);
		for (const CellPolygon& other : others)
			for (const std::uint32_t v : mesh_.polygon(polygon.polygon))
				for (const std::uint32_t w : mesh_.polygon(other.polygon))
					if (coincide(mesh_.edges[v], face, mesh_.edges[w], other_face))
						pairs_.emplace_back(v, w);
	}

	std::vector<Corner> corners(std::uint32_t block, CellId cell, std::uint32_t face) const
	{
		return std::visit(
		    [&](const auto& grid)
		    {
			    grid::CellFaces faces;
			    grid.cellFaces(cell, faces);
			    std::vector<Corner> found;
			    for (const PointId p : faces[static_cast<int>(face)])
				    found.push_back({p, grid.point(p)});
			    return found;
		    },
		    blocks_.blocks[block].grid);
	}

	// The place of a point of `face` among the corners of the face that lies on it; -1 for points of other faces.
	static int placeOf(PointId point, const std::vector<Corner>& face, const std::vector<Corner>& other_face)
	{
		const auto at = std::ranges::find(face, point, &Corner::id);
		if (at == face.end())
			return -1;
		const auto distance = [&](const Corner& c) { return glm::length(c.position - at->position); };
		return static_cast<int>(std::ranges::min_element(other_face, {}, distance) - other_face.begin());
	}

	// Whether two vertices cut the same edge, or lie on the same corner, of faces that coincide.
	static bool coincide(const EdgePoint& v, const std::vector<Corner>& face, const EdgePoint& w,
	                     const std::vector<Corner>& other_face)
	{
		const bool at_corner = v.t == 0.0 || v.t == 1.0;
		if (at_corner != (w.t == 0.0 || w.t == 1.0))
			return false;
		if (at_corner)
		{
			const int place = placeOf(v.t == 0.0 ? v.lower : v.higher, face, other_face);
			return place >= 0 && place == placeOf(w.t == 0.0 ? w.lower : w.higher, other_face, other_face);
		}
		const int lower = placeOf(v.lower, face, other_face);
		const int higher = placeOf(v.higher, face, other_face);
		const int other_lower = placeOf(w.lower, other_face, other_face);
		const int other_higher = placeOf(w.higher, other_face, other_face);
		return lower >= 0 && higher >= 0 &&
		       ((lower == other_lower && higher == other_higher) || (lower == other_higher && higher == other_lower));
	}

	const grid::BlockSet& blocks_;
	const grid::Interfaces& interfaces_;
	const SheetMesh& mesh_;
	std::vector<CellPolygon> at_seams_; // ascending by cell
	std::vector<VertexPair> pairs_;
};

} // namespace

std::vector<VertexPair> seamVertices(const grid::BlockSet& blocks, const grid::Interfaces& interfaces,
                                     const SheetMesh& mesh)
{
	return SeamVertices(blocks, interfaces, mesh).pairs();
}

} // namespace vp::mesh
