#pragma once

#include "base/ids.h"
#include "base/raw_vector.h"
#include "base/select.h"
#include "base/vec.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace vp::mesh
{

// Where a vertex lies: on the edge from the lower to the higher point id, at lower + t (higher - lower), 0 <= t <= 1.
// This is the vertex's identity too: a cut edge is one vertex, whatever number of cells share it. Where blocks meet, or
// points are not merged, an edge has several names, of which the vertex bears one (join_vertices.h).
struct EdgePoint
{
	std::uint32_t block;
	PointId lower;
	PointId higher;
	double t;
};

/// Returns true if two places differ by rounding alone. They lie on edges of about this length.
inline bool isOnePlace(const Vec3& a, const Vec3& b, double edge_length)
{
	constexpr double kOfEdge = 1e-12;
	constexpr double kOfCoordinate = 16.0 * std::numeric_limits<double>::epsilon();
	const Vec3 size = glm::abs(a);
	const double largest = std::max(size.x, std::max(size.y, size.z));
	return glm::length(a - b) <= kOfEdge * edge_length + kOfCoordinate * largest;
}

/// The place at t along the edge from a to b.
inline Vec3 placeOnEdge(const Vec3& a, const Vec3& b, double t)
{
	return t == 1.0 ? b : a + t * (b - a);
}

/// The same, to the last bit however the ends are numbered: `a_positive` tells on which side a lies. For grids whose
/// points get other numbers once neighbors are built.
inline Vec3 placeOfAnyNumbering(const Vec3& a, const Vec3& b, double t, bool a_positive)
{
	const Vec3 positive = select(a_positive, a, b);
	const Vec3 negative = select(a_positive, b, a);
	const double s = select(a_positive, t, 1.0 - t);
	return s == 1.0 ? negative : positive + s * (negative - positive);
}

// A grid point's part in a vertex that lies on no edge, such as on the rim of a window.
struct PointShare
{
	std::uint32_t block;
	PointId point;
	double weight; // the weights of a vertex sum up to 1
};

struct BlockCell
{
	std::uint32_t block;
	CellId cell;
};

// Polygons with shared vertices, in double precision: the cut of one sheet through a block set, which winds
// counter-clockwise seen from the side the sheet's normal points to; a grid surface (grid_surface.h); or the faces of
// cut cells (crinkle.h). Polygons with fewer than three distinct vertices are left out.
struct SheetMesh
{
	RawVector<Vec3> positions;
	RawVector<EdgePoint> edges; // per vertex that lies on a cell edge; they come first
	// Per vertex after them, on a window's rim or hanging on a larger cell (hanging_vertices.h), and 1: offsets into
	// rim_shares.
	std::vector<std::uint32_t> rim_starts{0};
	std::vector<PointShare> rim_shares;      // what the vertex is the weighted mean of
	RawVector<std::uint32_t> polygon_starts; // polygons + 1 offsets into polygon_vertices
	RawVector<std::uint32_t> polygon_vertices;
	RawVector<BlockCell> polygon_cells; // per polygon
	// Empty, or 1 for each entry of polygon_vertices that a join has put on a side of a larger cell's polygon, where
	// smaller cells have vertices (hanging_vertices.h). Figures leave these corners out (own_polygons.h).
	std::vector<std::uint8_t> is_added;
	// Empty, or 1 for each entry of polygon_vertices whose side, to the next entry, lies between two parts of one
	// polygon (nearest_parts.h). Lines of the mesh leave these sides out.
	std::vector<std::uint8_t> is_inner;
	std::size_t boundary_polygons = 0; // the last so many are boundary faces in the plane, of cells that are not cut
	// Vertices that lie on each other at a seam and yet stay two, since an array or the place differs from one side to
	// the other.
	std::vector<std::pair<std::uint32_t, std::uint32_t>> seam_pairs;
	std::size_t cells_twisted = 0; // cut cells with a face that is cut more than once, or with several polygons
	bool flat = true;              // every polygon lies in a plane; others are the fans about their vertices' means

	std::span<const PointShare> rimShares(std::size_t vertex) const
	{
		const std::size_t rim = vertex - edges.size();
		return std::span(rim_shares).subspan(rim_starts[rim], rim_starts[rim + 1] - rim_starts[rim]);
	}
	std::size_t polygons() const { return polygon_cells.size(); }
	std::span<const std::uint32_t> polygon(std::size_t i) const
	{
		return std::span(polygon_vertices).subspan(polygon_starts[i], polygon_starts[i + 1] - polygon_starts[i]);
	}
};

// Twice the vector area of a polygon (at least one vertex): for a flat polygon, of whatever form, twice its area along
// the normal about which it runs counter-clockwise.
Vec3 doubleArea(const SheetMesh& mesh, std::span<const std::uint32_t> polygon);

// A polygon as the fan of triangles about the mean of its vertices (at least three). visit(previous, vertex, area) per
// triangle; a triangle that runs against its polygon, as some do where that is concave, has a negative area.
template <class Visit>
void forFan(const SheetMesh& mesh, std::span<const std::uint32_t> polygon, Visit&& visit)
{
	const Vec3 double_area = doubleArea(mesh, polygon);
	const double length = glm::length(double_area);
	const Vec3 along = length > 0.0 ? double_area / length : Vec3(0.0);
	Vec3 center(0.0);
	for (const std::uint32_t v : polygon)
		center += mesh.positions[v];
	center /= static_cast<double>(polygon.size());
	std::uint32_t previous = polygon.back();
	for (const std::uint32_t v : polygon)
	{
		const Vec3 cross = glm::cross(mesh.positions[previous] - center, mesh.positions[v] - center);
		const double part = glm::dot(cross, along);
		// Off the plane of the whole a triangle has more area than is seen along it.
		visit(previous, v, 0.5 * (mesh.flat ? part : std::copysign(glm::length(cross), part)));
		previous = v;
	}
}

// Adds what a vertex is the weighted mean of to `shares`, which may be those of the mesh itself.
void addShares(const SheetMesh& mesh, std::uint32_t vertex, double weight, std::vector<PointShare>& shares);

// Returns the mesh without the polygons of some blocks. Vertices keep their numbers.
SheetMesh withoutBlocks(const SheetMesh& mesh, const std::vector<bool>& blocks);

// Drops the vertices that no polygon uses.
void dropUnusedVertices(SheetMesh& mesh);

} // namespace vp::mesh
