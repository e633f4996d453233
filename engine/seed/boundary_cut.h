#pragma once

#include "base/parallel_for.h"
#include "base/prefetch.h"
#include "grid/boundary.h"
#include "grid/grid.h"
#include "seed/sheet_window.h"
#include "surface/curved.h"
#include "surface/sign_filter.h"

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

// The faces that a cutting surface meets in a part of a boundary.
struct BoundaryCut
{
	std::vector<grid::BoundaryIndex::Face> cut;
	std::vector<grid::BoundaryIndex::Face> flat;
	std::size_t tests = 0; // number of boxes and faces tested
};

// The part of some groups of the index. With a window (or null) only faces that may reach into it.
template <grid::Grid G, class Surface>
class BoundarySearch
{
public:
	// bounds: of the grid's points.
	BoundarySearch(const G& grid, const grid::BoundaryIndex& boundary, const Box& bounds, const Surface& surface,
	               const SheetWindow* window)
	    : grid_(grid), boundary_(boundary), bounds_(bounds), surface_(surface), window_(window)
	{
	}

	// Searches the groups [begin, end).
	BoundaryCut search(std::size_t begin, std::size_t end)
	{
		const auto meets = [&](const Box& box) { return surface_.meets(box) && (!window_ || window_->meets(box)); };
		std::vector<Faces> patches;
		found_.tests = boundary_.visitWhere(begin, end, meets, [&](Faces patch) { patches.push_back(patch); });
		for (const Faces patch : patches)
			found_.tests += patch.size();
		askAll(patches);
		return std::move(found_);
	}

private:
	using Faces = std::span<const grid::BoundaryIndex::Face>;

	void askAll(std::span<const Faces> patches)
	{
		if constexpr (requires { grid_.coordinates(); } && !surface::kIsCurved<Surface>)
			if (!boundary_.corners.empty())
			{
				if (grid_.coordinates().isDouble())
					askByFours<double>(patches);
				else
					askByFours<float>(patches);
				return;
			}
		for (const Faces patch : patches)
			askEach(patch);
	}

	using Corners = std::span<const std::array<PointId, 4>>; // per face

	// Four faces at a time in float, where that is certain: most faces of a patch are not cut.
	template <class Number>
	void askByFours(std::span<const Faces> patches)
	{
		const Number* xyz = grid_.coordinates().template numbers<Number>();
		const surface::SignFilter filter(surface_, bounds_);
		for (std::size_t p = 0; p < patches.size(); ++p)
		{
			if (p + 1 < patches.size())
				prefetchPoints(cornersOf(patches[p + 1]), xyz);
			for (std::size_t first = 0; first < patches[p].size(); first += 4)
			{
				const Faces faces = patches[p].subspan(first, std::min<std::size_t>(4, patches[p].size() - first));
				const unsigned signs = signsOf(cornersOf(faces), xyz, filter);
				if (signs == surface::SignFilter::kInDoubt)
					askEach(faces);
				else
					takeCut(faces, signs);
			}
		}
	}
	Corners cornersOf(Faces faces) const
	{
		return Corners(boundary_.corners)
		    .subspan(static_cast<std::size_t>(faces.data() - boundary_.faces.data()), faces.size());
	}
	template <class Number>
	static void prefetchPoints(Corners corners, const Number* xyz)
	{
		for (const auto& [a, b, c, d] : corners)
		{
			prefetch(xyz + 3 * std::size_t(a));
			prefetch(xyz + 3 * std::size_t(c));
		}
	}
	// Returns the signs of one to four faces.
	template <class Number>
	static unsigned signsOf(Corners corners, const Number* xyz, const surface::SignFilter& filter)
	{
		const auto pointsOf = [&](std::size_t face)
		{
			const auto at = [=](PointId point) { return xyz + 3 * std::size_t(point); };
			const auto& [a, b, c, d] = corners[std::min(face, corners.size() - 1)];
			return surface::gatherFour(std::array{at(a), at(b), at(c), at(d)});
		};
		return filter.sixteen({pointsOf(0), pointsOf(1), pointsOf(2), pointsOf(3)});
	}
	// signs: as SignFilter::sixteen() gives them.
	void takeCut(Faces faces, unsigned signs)
	{
		const unsigned any = signs | signs >> 4 | signs >> 8 | signs >> 12;
		const unsigned all = signs & signs >> 4 & signs >> 8 & signs >> 12;
		for (std::size_t face = 0; face < faces.size(); ++face)
			if ((any & ~all) >> face & 1)
				takeCut(faces[face]);
	}
	void takeCut(const grid::BoundaryIndex::Face& face)
	{
		if (!window_)
			found_.cut.push_back(face);
		else
			useFacePoints(grid_, face.cell, face.face, faces_,
			              [&](std::span<const PointId> points)
			              {
				              if (window_->meetsFace(grid_, surface_, points))
					              found_.cut.push_back(face);
			              });
	}

	void askEach(Faces faces)
	{
		for (const grid::BoundaryIndex::Face& face : faces)
			useFacePoints(grid_, face.cell, face.face, faces_,
			              [&](std::span<const PointId> points) { askFace(face, points); });
	}
	void askFace(const grid::BoundaryIndex::Face& face, std::span<const PointId> points)
	{
		bool any_positive = false;
		bool all_positive = true;
		bool flat = true;
		for (const PointId p : points)
		{
			const double height = surface::heightAt(grid_, surface_, p);
			any_positive |= height >= 0.0;
			all_positive &= height >= 0.0;
			flat &= height == 0.0;
		}
		if (any_positive && !all_positive)
			takeCut(face);
		else if (flat && (!window_ || window_->meetsFlatFace(grid_, points)))
			found_.flat.push_back(face);
	}

	const G& grid_;
	const grid::BoundaryIndex& boundary_;
	const Box bounds_;
	const Surface& surface_;
	const SheetWindow* window_;
	grid::CellFaces faces_;
	BoundaryCut found_;
};

// Calls visit_cut(face) for every boundary face with vertices on both sides: its cell is cut. Calls visit_flat(face)
// for every one that lies wholly in the surface. With a window (or null) only faces that may reach into the window
// count. The calls come one after the other in the order of the index, although the search runs on all cores. bounds:
// bounds of the grid's points. Returns the number of boxes and faces tested.
template <grid::Grid G, class Surface, class VisitCut, class VisitFlat>
std::size_t visitBoundaryCut(const G& grid, const grid::BoundaryIndex& boundary, const Box& bounds,
                             const Surface& surface, const SheetWindow* window, VisitCut&& visit_cut,
                             VisitFlat&& visit_flat)
{
	constexpr std::size_t kGroups = 16; // at a time: some 10 us of work
	std::vector<BoundaryCut> parts((boundary.groups.size() + kGroups - 1) / kGroups);
	tracedFor(std::size_t(0), parts.size(),
	          [&](std::size_t n)
	          {
		          const std::size_t end = std::min((n + 1) * kGroups, boundary.groups.size());
		          parts[n] = BoundarySearch(grid, boundary, bounds, surface, window).search(n * kGroups, end);
	          });
	std::size_t tests = 0;
	for (const BoundaryCut& part : parts)
	{
		for (const grid::BoundaryIndex::Face& face : part.cut)
			visit_cut(face);
		for (const grid::BoundaryIndex::Face& face : part.flat)
			visit_flat(face);
		tests += part.tests;
	}
	return tests;
}

// The segment in which a surface cuts a boundary face with points on both sides.
template <grid::Grid G, class Surface>
CutFace cutFace(const G& grid, const Surface& surface, const grid::BoundaryIndex::Face& face)
{
	CutFace cut{face.cell, {}, {}};
	grid::CellFaces faces;
	useFacePoints(grid, face.cell, face.face, faces,
	              [&](std::span<const PointId> points)
	              {
		              Vec3* end = &cut.from;
		              PointId previous = points.back();
		              double previous_height = surface::heightAt(grid, surface, previous);
		              for (const PointId p : points)
		              {
			              const double height = surface::heightAt(grid, surface, p);
			              if ((height >= 0.0) != (previous_height >= 0.0) && end)
			              {
				              const Vec3 a = grid.point(previous);
				              const Vec3 b = grid.point(p);
				              *end = a + surface::crossingOf(surface, a, b, previous_height, height) * (b - a);
				              end = end == &cut.from ? &cut.to : nullptr;
			              }
			              previous = p;
			              previous_height = height;
		              }
	              });
	return cut;
}

} // namespace vp::seed
