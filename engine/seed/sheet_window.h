#pragma once

#include "grid/grid.h"
#include "probe/sheet.h"
#include "seed/face_cuts.h"

#include <span>

namespace vp::seed
{

// The window of a sheet as seeding and traversal see it: an edge of a polygon that lies wholly outside leads nowhere.
// A polygon that touches the window's rim counts as inside.
class SheetWindow
{
public:
	explicit SheetWindow(const probe::Sheet& content); // has a window and no fx, see probe::content()

	// Returns true if the window may reach into a box.
	bool meets(const Box& box) const;
	// Returns true if a segment in the plane reaches into the window.
	bool meets(const Vec3& from, const Vec3& to) const;

	// Returns true if a face is cut within the window. If a twisted face is cut more than twice, any two cuts count as
	// joined, so that nothing is lost.
	template <class G, class Surface>
	bool meetsFace(const G& grid, const Surface& surface, std::span<const PointId> face) const
	{
		Cuts cuts;
		return findCuts(grid, surface, face, cuts) && anyMeets(cuts);
	}

	// Returns true if a face that lies in the plane reaches into the window. The window may lie inside the face.
	template <class G>
	bool meetsFlatFace(const G& grid, std::span<const PointId> face) const
	{
		bool inside = false; // as in meetsCell()
		for (std::size_t i = 0; i < face.size(); ++i)
		{
			const Vec3 from = grid.point(face[i]), to = grid.point(face[(i + 1) % face.size()]);
			if (meets(from, to))
				return true;
			inside ^= passesRightOfCenter(uvOf(from), uvOf(to));
		}
		return inside;
	}

	// Returns true if the section of a cut cell reaches into the window. The window may lie inside the section.
	template <class G, class Surface>
	bool meetsCell(const G& grid, const Surface& surface, const grid::CellFaces& faces) const
	{
		bool inside = false; // the window's center is: an odd number of the section's sides lie to one side of it
		bool unsure = false;
		Cuts cuts;
		for (int f = 0; f < faces.size(); ++f)
		{
			if (!findCuts(grid, surface, faces[f], cuts))
				continue;
			if (anyMeets(cuts))
				return true;
			// Which cuts are joined matters only where the center lies between them.
			unsure = unsure || (cuts.count > 2 && (cuts.count > 4 || isAboutCenter(cuts)));
			for (int cut = 0; cut + 1 < cuts.count; cut += 2)
				inside ^= passesRightOfCenter(cuts.at[cut], cuts.at[cut + 1]);
		}
		return inside || unsure;
	}

	// Returns true if a cell lies within the window, seen along the normal. Then its whole section does. Returns false
	// if that is uncertain by rounding, and for polyhedra.
	template <class G>
	bool holdsCell(const G& grid, CellId cell) const
	{
		if (grid.shape(cell) == grid::CellShape::polyhedron)
			return false;
		for (const PointId p : grid.cellPoints(cell))
			if (!holds(grid.point(p)))
				return false;
		return true;
	}

	// The window's sides: `lo` to `hi` along the axes from the origin.
	const Vec3& origin() const { return origin_; }
	const Vec3& axis(int of) const { return of == 0 ? x_axis_ : y_axis_; }
	const glm::dvec2& lo() const { return lo_; }
	const glm::dvec2& hi() const { return hi_; }

	// Returns a point of the window to start from: the origin of the sheet if it is inside, otherwise the center of the
	// window.
	const Vec3& hotSpot() const { return hot_spot_; }

private:
	using Uv = glm::dvec2;
	using Cuts = FaceCuts<2>;

	bool holds(const Vec3& p) const
	{
		const Vec3 from_origin = p - origin_;
		const Uv uv(glm::dot(from_origin, x_axis_), glm::dot(from_origin, y_axis_));
		// Far from the plane, rounding may be larger than the slack of the sides.
		return uv.x >= lo_.x + slack_ && uv.x <= hi_.x - slack_ && uv.y >= lo_.y + slack_ && uv.y <= hi_.y - slack_ &&
		       glm::dot(from_origin, from_origin) <= reach_squared_;
	}
	Uv uvOf(const Vec3& p) const { return {glm::dot(p - origin_, x_axis_), glm::dot(p - origin_, y_axis_)}; }

	template <class G, class Surface>
	bool findCuts(const G& grid, const Surface& surface, std::span<const PointId> face, Cuts& cuts) const
	{
		return seed::findCuts(
		    grid, surface, face, [this](const Vec3& p) { return uvOf(p); }, cuts);
	}
	bool anyMeets(const Cuts& cuts) const { return anyReaches(cuts, lo_, hi_); }
	bool passesRightOfCenter(const Uv& from, const Uv& to) const;
	bool isAboutCenter(const Cuts& cuts) const; // the loop through all of them

	Vec3 origin_;
	Vec3 x_axis_;
	Vec3 y_axis_;
	Uv lo_;
	Uv hi_;
	double slack_; // slack of the sides
	double reach_squared_;
	Vec3 hot_spot_;
};

} // namespace vp::seed
