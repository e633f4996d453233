#pragma once

#include "mesh/clip.h"
#include "probe/transform.h"
#include "seed/face_cuts.h"

#include <array>
#include <span>

namespace vp::contour
{

// The clip box of a sheet as a traversal sees it: what seed::SheetWindow is in two dimensions. A face whose cut lies
// wholly outside leads nowhere; what touches the box's rim counts as inside.
class ClipBox
{
public:
	// From `lo` to `hi` along the frame's x and y axes and its normal, from its origin, in the grid's units.
	ClipBox(const probe::Frame& frame, const Vec3& lo, const Vec3& hi);

	// Returns true if a face is cut within the box.
	template <class G, class Surface>
	bool meetsFace(const G& grid, const Surface& surface, std::span<const PointId> face) const
	{
		Cuts cuts;
		return findCuts(grid, surface, face, cuts) && seed::anyReaches(cuts, lo_, hi_);
	}

	// Returns true if the section of a cut cell may reach into the box. The section may bend. If none of its sides
	// reaches in, the box of its corners decides. So a few more cells may pass, but none is lost.
	template <class G, class Surface>
	bool meetsCell(const G& grid, const Surface& surface, const grid::CellFaces& faces) const
	{
		Box section;
		Cuts cuts;
		for (int f = 0; f < faces.size(); ++f)
		{
			if (!findCuts(grid, surface, faces[f], cuts))
				continue;
			if (seed::anyReaches(cuts, lo_, hi_))
				return true;
			for (int cut = 0; cut < cuts.count; ++cut)
				section.include(cuts.at[cut]);
		}
		return holdsPartOf(section);
	}

	// Returns true if a cell lies within the box; then its whole section does. It is not called for polyhedra.
	template <class G>
	bool holdsCell(const G& grid, CellId cell) const
	{
		if (grid.shape(cell) == grid::CellShape::polyhedron)
			return false;
		for (const PointId p : grid.cellPoints(cell))
			if (!holds(inBox(grid.point(p))))
				return false;
		return true;
	}

	// Returns true if a box along the axes of the grid may reach into it.
	bool meets(const Box& box) const;

	const probe::Frame& frame() const { return frame_; }
	const Vec3& lo() const { return box_.lo; }
	const Vec3& hi() const { return box_.hi; }
	// Coordinates along the axes of the box, from the origin of the frame.
	Vec3 inBox(const Vec3& p) const
	{
		const Vec3 from = p - frame_.origin;
		return {glm::dot(from, x_axis_), glm::dot(from, frame_.up), glm::dot(from, frame_.normal)};
	}
	// For mesh::clipToSides(), about the frame's origin.
	std::array<mesh::ClipSide, 6> sides() const;

private:
	using Cuts = seed::FaceCuts<3>;

	template <class G, class Surface>
	bool findCuts(const G& grid, const Surface& surface, std::span<const PointId> face, Cuts& cuts) const
	{
		return seed::findCuts(
		    grid, surface, face, [this](const Vec3& p) { return inBox(p); }, cuts);
	}
	bool holdsPartOf(const Box& section) const; // in the coordinates of the box
	// By more than rounding.
	bool holds(const Vec3& place) const
	{
		const Vec3 slack = box_.lo - lo_;
		return glm::all(glm::greaterThan(place, box_.lo + slack)) && glm::all(glm::lessThan(place, box_.hi - slack));
	}

	probe::Frame frame_;
	Vec3 x_axis_;
	Box box_;
	Vec3 lo_; // with a slack for rounding
	Vec3 hi_;
};

} // namespace vp::contour
