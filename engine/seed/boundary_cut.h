#pragma once

#include "grid/boundary.h"
#include "grid/grid.h"
#include "seed/sheet_window.h"
#include "surface/curved.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace vp::seed
{

// A boundary face that a cutting surface cuts, and the segment it is cut in (of a face cut more than twice, the first).
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

// What a cutting surface has in common with a part of a boundary.
struct BoundaryCut
{
	std::vector<CutFace> cut;
	std::vector<grid::BoundaryIndex::Face> flat;
	std::size_t tests = 0; // boxes and faces asked
};

// The part of groups [begin, end) of the index. With a window (or null) only faces that may reach into it.
template <grid::Grid G, class Surface>
class BoundarySearch
{
public:
	BoundarySearch(const G& grid, const Surface& surface, const SheetWindow* window)
	    : grid_(grid), surface_(surface), window_(window)
	{
	}

	BoundaryCut search(const grid::BoundaryIndex& boundary, std::size_t begin, std::size_t end)
	{
		const auto meets = [&](const Box& box) { return surface_.meets(box) && (!window_ || window_->meets(box)); };
		const std::size_t boxes = boundary.visitWhere(begin, end, meets, [&](const auto& faces) { askPatch(faces); });
		found_.tests += boxes;
		return std::move(found_);
	}

private:
	void askPatch(std::span<const grid::BoundaryIndex::Face> faces)
	{
		found_.tests += faces.size();
		for (const grid::BoundaryIndex::Face& face : faces)
			useFacePoints(grid_, face.cell, face.face, faces_,
			              [&](std::span<const PointId> points) { askFace(face, points); });
	}

	void askFace(const grid::BoundaryIndex::Face& face, std::span<const PointId> points)
	{
		Vec3 previous = grid_.point(points.back());
		double previous_distance = surface::heightAt(grid_, surface_, points.back());
		Vec3 ends[2];
		int found = 0;
		bool flat = true;
		for (const PointId p : points)
		{
			const Vec3 corner = grid_.point(p);
			const double distance = surface::heightAt(grid_, surface_, p);
			if ((distance >= 0.0) != (previous_distance >= 0.0) && found < 2)
				ends[found++] =
				    previous +
				    surface::crossingOf(surface_, previous, corner, previous_distance, distance) * (corner - previous);
			flat = flat && distance == 0.0;
			previous = corner;
			previous_distance = distance;
		}
		if (found == 2 && (!window_ || window_->meetsFace(grid_, surface_, points)))
			found_.cut.push_back({face.cell, ends[0], ends[1]});
		else if (flat && (!window_ || window_->meets(boxOf(grid_, points))))
			found_.flat.push_back(face);
	}

	const G& grid_;
	const Surface& surface_;
	const SheetWindow* window_;
	grid::CellFaces faces_;
	BoundaryCut found_;
};

// Calls visit_cut(CutFace) for every boundary face with vertices on both sides: its cell is cut. Calls visit_flat(Face)
// for every one that lies in the surface whole. With a window (or null) only those that may reach into it. In the order
// of the index, one after the other, though they are looked for on all cores. Returns the boxes and faces asked.
template <grid::Grid G, class Surface, class VisitCut, class VisitFlat>
std::size_t visitBoundaryCut(const G& grid, const grid::BoundaryIndex& boundary, const Surface& surface,
                             const SheetWindow* window, VisitCut&& visit_cut, VisitFlat&& visit_flat)
{
	constexpr std::size_t kGroups = 16; // at a time: some 10 us of work
	std::vector<BoundaryCut> parts((boundary.groups.size() + kGroups - 1) / kGroups);
	tbb::parallel_for(std::size_t(0), parts.size(),
	                  [&](std::size_t n)
	                  {
		                  const std::size_t end = std::min((n + 1) * kGroups, boundary.groups.size());
		                  parts[n] = BoundarySearch(grid, surface, window).search(boundary, n * kGroups, end);
	                  });
	std::size_t tests = 0;
	for (const BoundaryCut& part : parts)
	{
		for (const CutFace& face : part.cut)
			visit_cut(face);
		for (const grid::BoundaryIndex::Face& face : part.flat)
			visit_flat(face);
		tests += part.tests;
	}
	return tests;
}

} // namespace vp::seed
