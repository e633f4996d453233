#pragma once

#include "grid/boundary.h"
#include "grid/grid.h"
#include "seed/sheet_window.h"
#include "surface/plane.h"

#include <array>
#include <cstddef>

namespace vp::seed
{

// A boundary face that the plane cuts, and the segment it is cut in (of a face cut more than twice, the first).
struct CutFace
{
	CellId cell;
	Vec3 from;
	Vec3 to;
};

inline Vec3 nearestOnSegment(const Vec3& from, const Vec3& to, const Vec3& p)
{
	const Vec3 along = to - from;
	const double square = glm::dot(along, along);
	const double t = square > 0.0 ? glm::clamp(glm::dot(p - from, along) / square, 0.0, 1.0) : 0.0;
	return from + t * along;
}

template <grid::Grid G>
Box boxOf(const G& grid, std::span<const PointId> points)
{
	Box box;
	for (const PointId p : points)
		box.include(grid.point(p));
	return box;
}

// The points of one face, in the order that the cell's faces have them. `faces` is what those of a polyhedron are kept
// in.
template <grid::Grid G, class Use>
void useFacePoints(const G& grid, CellId cell, std::uint32_t face, grid::CellFaces& faces, Use&& use)
{
	const grid::CellShape shape = grid.shape(cell);
	if (shape == grid::CellShape::polyhedron)
	{
		grid.cellFaces(cell, faces);
		return use(faces[static_cast<int>(face)]);
	}
	const grid::CellPoints points = grid.cellPoints(cell);
	const std::span<const std::uint8_t> corners = grid::topology(shape).facePoints(static_cast<int>(face));
	std::array<PointId, 4> ids;
	for (std::size_t v = 0; v < corners.size(); ++v)
		ids[v] = points.id[corners[v]];
	use(std::span<const PointId>(ids.data(), corners.size()));
}

// Calls visit_cut(CutFace) for every boundary face with vertices on both sides: its cell is cut. Calls visit_flat(Face)
// for every one that lies in the plane whole. With a window (or null) only those that may reach into it. Returns the
// boxes and faces asked.
template <grid::Grid G, class VisitCut, class VisitFlat>
std::size_t visitBoundaryCut(const G& grid, const grid::BoundaryIndex& boundary, const surface::Plane& plane,
                             const SheetWindow* window, VisitCut&& visit_cut, VisitFlat&& visit_flat)
{
	std::size_t face_tests = 0;
	grid::CellFaces faces;
	const auto testPoints = [&](const grid::BoundaryIndex::Face& face, std::span<const PointId> points)
	{
		Vec3 previous = grid.point(points.back());
		double previous_distance = plane.signedDistance(previous);
		Vec3 ends[2];
		int found = 0;
		bool flat = true;
		for (const PointId p : points)
		{
			const Vec3 corner = grid.point(p);
			const double distance = plane.signedDistance(corner);
			if ((distance >= 0.0) != (previous_distance >= 0.0) && found < 2)
				ends[found++] = previous + (previous_distance / (previous_distance - distance)) * (corner - previous);
			flat = flat && distance == 0.0;
			previous = corner;
			previous_distance = distance;
		}
		if (found == 2 && (!window || window->meetsFace(grid, plane, points)))
			visit_cut(CutFace{face.cell, ends[0], ends[1]});
		else if (flat && (!window || window->meets(boxOf(grid, points))))
			visit_flat(face);
	};
	const auto test = [&](const grid::BoundaryIndex::Face& face)
	{
		++face_tests;
		useFacePoints(grid, face.cell, face.face, faces,
		              [&](std::span<const PointId> points) { testPoints(face, points); });
	};
	const std::size_t box_tests =
	    boundary.visitWhere([&](const Box& box) { return plane.meets(box) && (!window || window->meets(box)); }, test);
	return box_tests + face_tests;
}

} // namespace vp::seed
