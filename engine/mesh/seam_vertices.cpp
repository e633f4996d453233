#include "mesh/seam_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

struct PolygonEdge
{
	std::size_t polygon;
	std::uint32_t from;
	std::uint32_t to;
};

// A point of a face and where it lies.
struct Corner
{
	PointId id;
	Vec3 position;
};

class SeamFinder
{
public:
	SeamFinder(const grid::BlockSet& blocks, const grid::Interfaces& interfaces, const SheetMesh& mesh)
	    : blocks_(blocks), interfaces_(interfaces), mesh_(mesh)
	{
	}

	SeamVertices find()
	{
		for (std::size_t p = 0; p < mesh_.polygons(); ++p)
			if (const grid::BlockSeams* seams = seamsOf(p);
			    seams && !seams->ofCell(mesh_.polygon_cells[p].cell).empty())
				at_seams_.push_back({mesh_.polygon_cells[p], p});
		std::ranges::stable_sort(at_seams_, before, &CellPolygon::cell);
		for (auto first = at_seams_.begin(); first != at_seams_.end();)
		{
			const auto last = std::upper_bound(first, at_seams_.end(), *first,
			                                   [](const auto& a, const auto& b) { return before(a.cell, b.cell); });
			addCell({first, last});
			first = last;
		}
		return std::move(found_);
	}

private:
	const grid::BlockSeams* seamsOf(std::size_t polygon) const
	{
		return interfaces_.of(mesh_.polygon_cells[polygon].block);
	}

	void addCell(std::span<const CellPolygon> polygons)
	{
		const BlockCell cell = polygons.front().cell;
		for (const grid::SeamLink& link : interfaces_.of(cell.block)->ofCell(cell.cell))
			if (link.hang == grid::Hang::large)
				addHanging(polygons, link);
			else if (link.hang == grid::Hang::none && before(cell, {link.block, link.other}))
				for (const CellPolygon& polygon : polygons)
					addAcross(polygon, link);
	}

	void addAcross(const CellPolygon& polygon, const grid::SeamLink& link)
	{
		const std::span<const CellPolygon> others = polygonsAcross(link);
		if (others.empty())
			return;
		const std::vector<Corner> face = corners(polygon.cell.block, link.cell, link.face);
		const std::vector<Corner> other_face = corners(link.block, link.other, link.other_face);
		for (const CellPolygon& other : others)
			for (const std::uint32_t v : mesh_.polygon(polygon.polygon))
				for (const std::uint32_t w : mesh_.polygon(other.polygon))
					if (coincide(mesh_.edges[v], face, mesh_.edges[w], other_face))
						found_.pairs.emplace_back(v, w);
	}

	std::span<const CellPolygon> polygonsAcross(const grid::SeamLink& link) const
	{
		const BlockCell other_cell{link.block, link.other};
		return {std::ranges::lower_bound(at_seams_, other_cell, before, &CellPolygon::cell),
		        std::ranges::upper_bound(at_seams_, other_cell, before, &CellPolygon::cell)};
	}

	// The vertices of the small cell's polygons that lie on the seam, each on the nearest edge that the large cell's
	// polygons have there.
	void addHanging(std::span<const CellPolygon> polygons, const grid::SeamLink& link)
	{
		const std::span<const CellPolygon> others = polygonsAcross(link);
		if (others.empty())
			return;
		const std::vector<Corner> face = corners(polygons.front().cell.block, link.cell, link.face);
		const std::vector<Corner> small_face = corners(link.block, link.other, link.other_face);
		edges_.clear();
		for (const CellPolygon& polygon : polygons)
		{
			const std::span<const std::uint32_t> vertices = mesh_.polygon(polygon.polygon);
			for (std::size_t i = 0; i < vertices.size(); ++i)
			{
				const std::uint32_t from = vertices[i];
				const std::uint32_t to = vertices[(i + 1) % vertices.size()];
				if (liesOn(mesh_.edges[from], face) && liesOn(mesh_.edges[to], face))
					edges_.push_back({polygon.polygon, from, to});
			}
		}
		for (const CellPolygon& other : others)
			for (const std::uint32_t w : mesh_.polygon(other.polygon))
				if (!edges_.empty() && liesOn(mesh_.edges[w], small_face))
					addToNearest(w);
	}

	void addToNearest(std::uint32_t w)
	{
		// A warped side may have vertices beyond the ends of the polygon's edge. They are not these ends.
		constexpr double kInside = 1e-9;
		const Vec3 place = mesh_.positions[w];
		double nearest = std::numeric_limits<double>::infinity();
		HangingVertex best{};
		for (const PolygonEdge& edge : edges_)
		{
			const Vec3 start = mesh_.positions[edge.from];
			const Vec3 along = mesh_.positions[edge.to] - start;
			const double square = glm::dot(along, along);
			const double at = square > 0.0 ? glm::dot(place - start, along) / square : 0.0;
			const double distance = glm::length(start + std::clamp(at, 0.0, 1.0) * along - place);
			if (!(distance < nearest))
				continue;
			nearest = distance;
			best = {w, edge.polygon, edge.from, edge.to,
			        areOnePlace(edge.from, w) ? 0.0
			        : areOnePlace(edge.to, w) ? 1.0
			                                  : std::clamp(at, kInside, 1.0 - kInside)};
		}
		found_.hanging.push_back(best);
	}

	// Returns true if a vertex of the large cell and one of the small cell cut one edge, of which the small cell has a
	// part, or if they lie on one point. If the sheet runs along the edge, the place of the cut is uncertain.
	bool areOnePlace(std::uint32_t v, std::uint32_t w) const
	{
		constexpr double kApart = 1e-6; // share of the edge
		const EdgePoint& large = mesh_.edges[v];
		const EdgePoint& small = mesh_.edges[w];
		const Vec3 a = pointOf(large.block, large.lower);
		const Vec3 along = pointOf(large.block, large.higher) - a;
		const double square = glm::dot(along, along);
		const double slack = kApart * std::sqrt(square);
		if (glm::length(mesh_.positions[v] - mesh_.positions[w]) <= slack)
			return true;
		if (!(square > 0.0) || large.t == 0.0 || large.t == 1.0 || small.t == 0.0 || small.t == 1.0)
			return false;
		const auto isOn = [&](const Vec3& p)
		{
			const double at = std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0);
			return glm::length(a + at * along - p) <= slack;
		};
		return isOn(pointOf(small.block, small.lower)) && isOn(pointOf(small.block, small.higher));
	}

	Vec3 pointOf(std::uint32_t block, PointId point) const
	{
		return std::visit([&](const auto& grid) { return grid.point(point); }, blocks_.blocks[block].grid);
	}

	// Returns true if a vertex lies on a face of its cell: its edge, or the grid point at which it lies, is on the
	// face.
	static bool liesOn(const EdgePoint& vertex, const std::vector<Corner>& face)
	{
		const auto has = [&](PointId p) { return std::ranges::find(face, p, &Corner::id) != face.end(); };
		return (vertex.t == 1.0 || has(vertex.lower)) && (vertex.t == 0.0 || has(vertex.higher));
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

	// Returns true if two vertices cut the same edge, or lie on the same corner, of faces that coincide.
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
	std::vector<PolygonEdge> edges_;    // edges of the current large cell on the current side
	SeamVertices found_;
};

} // namespace

SeamVertices seamVertices(const grid::BlockSet& blocks, const grid::Interfaces& interfaces, const SheetMesh& mesh)
{
	return SeamFinder(blocks, interfaces, mesh).find();
}

} // namespace vp::mesh
