#pragma once

#include "cases/case_table.h"
#include "cases/cell_walk.h"
#include "cases/face_pairs.h"
#include "cases/nested_loops.h"
#include "find/cell_signs.h"
#include "grid/grid.h"
#include "surface/curved.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace vp::mesh
{

// Gives the polygons of a cut cell as pairs of point ids {positive, negative} per cut edge, in polygon order: from the
// case table where it has an entry, by walking the cell's faces otherwise. A polygon with holes is one loop
// (cases/nested_loops.h). Reused from cell to cell to save allocations.
template <grid::Grid G, class Surface>
class CellPolygons
{
public:
	using Edge = std::pair<PointId, PointId>; // positive, negative

	CellPolygons(const G& grid, const Surface& surface) : grid_(grid), surface_(surface)
	{
		for (int s = 0; s < grid::kTableShapes; ++s)
			tables_[s] = cases::caseTable(static_cast<grid::CellShape>(s)).data();
	}

	// Returns the table's entry for a cut cell, or null if the cell's faces must be walked.
	const cases::Case* entryOf(CellId cell, std::uint32_t code) const
	{
		const grid::CellShape shape = grid_.shape(cell);
		if (shape == grid::CellShape::polyhedron)
			return nullptr;
		const cases::Case& entry = tables_[static_cast<std::size_t>(shape)][code & 0xFFu];
		return entry.needs_walk ? nullptr : &entry;
	}

	// Calls visit(std::span<const Edge>) per polygon. Returns whether the cell is twisted: a face cut more than once,
	// or several loops.
	template <class Visit>
	bool visit(CellId cell, std::uint32_t code, Visit&& visit)
	{
		if (const cases::Case* entry = entryOf(cell, code))
		{
			const grid::CellPoints points = grid_.cellPoints(cell);
			std::array<Edge, cases::kMaxPolygon> edges;
			for (int e = 0; e < entry->edges; ++e)
				edges[e] = {points.id[entry->edge[e][0]], points.id[entry->edge[e][1]]};
			if (entry->edges)
				visit(std::span<const Edge>(edges.data(), entry->edges));
			return false;
		}
		walk(cell);
		for (int p = 0; p < cut_.polygons(); ++p)
		{
			edges_.clear();
			for (std::uint32_t e = cut_.starts[p]; e < cut_.starts[p + 1]; ++e)
				edges_.emplace_back(local_points_[cut_.edges[e].positive], local_points_[cut_.edges[e].negative]);
			visit(std::span<const Edge>(edges_));
		}
		return is_ambiguous_;
	}

private:
	void walk(CellId cell)
	{
		grid_.cellFaces(cell, faces_);
		local_points_ = faces_.points;
		std::sort(local_points_.begin(), local_points_.end());
		local_points_.erase(std::unique(local_points_.begin(), local_points_.end()), local_points_.end());
		points_.clear();
		positive_.clear();
		for (const PointId p : local_points_)
		{
			points_.push_back({grid_.point(p), surface::heightAt(grid_, surface_, p)});
			positive_.push_back(points_.back().height >= 0.0);
		}
		walk_faces_.points.clear();
		walk_faces_.starts = faces_.starts;
		for (const PointId p : faces_.points)
			walk_faces_.points.push_back(static_cast<std::uint16_t>(
			    std::lower_bound(local_points_.begin(), local_points_.end(), p) - local_points_.begin()));
		const auto pairing = [&](int f, std::span<cases::Crossing> crossings)
		{
			face_.clear();
			for (const std::uint16_t p : walk_faces_[f])
				face_.push_back(points_[p]);
			return face_pairs_.of(face_, crossings, [&](const cases::Crossing& c) { return placeOf(c.edge); });
		};
		cases::walkCell(walk_faces_, std::span<const std::uint8_t>(positive_), pairing, cut_);
		is_ambiguous_ = cut_.ambiguous || cut_.polygons() > 1;
		if (cut_.polygons() > 1)
			joinNested();
	}

	cases::FacePairs::Placed placeOf(const cases::CutEdge& edge) const
	{
		const cases::FacePoint& from = points_[edge.positive];
		const cases::FacePoint& to = points_[edge.negative];
		const double t = surface::crossingOf(surface_, from.place, to.place, from.height, to.height);
		const Vec3 way = to.place - from.place;
		return {from.place + t * way, way / (from.height - to.height)};
	}

	// Seen along the axis that is nearest to the way in which the heights rise.
	void joinNested()
	{
		Vec3 rise(0.0);
		if constexpr (surface::kIsCurved<Surface>)
			for (const cases::CutEdge& edge : cut_.edges)
				rise += points_[edge.positive].place - points_[edge.negative].place;
		else
			rise = surface_.normal();
		const Vec3 size = glm::abs(rise);
		const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
		const Vec3 origin = points_[cut_.edges.front().positive].place;
		seen_.clear();
		for (const cases::CutEdge& edge : cut_.edges)
		{
			const Vec3 at = placeOf(edge).place - origin;
			seen_.emplace_back(at[(axis + 1) % 3], at[(axis + 2) % 3]);
		}
		cases::joinNestedLoops(cut_, seen_);
	}

	const G& grid_;
	const Surface& surface_;
	std::array<const cases::Case*, grid::kTableShapes> tables_;
	grid::CellFaces faces_;
	std::vector<PointId> local_points_;    // points of the walked cell, ascending
	std::vector<cases::FacePoint> points_; // the same
	std::vector<std::uint8_t> positive_;   // the same
	std::vector<cases::FacePoint> face_;
	cases::WalkFaces walk_faces_;
	cases::FacePairs face_pairs_;
	cases::CellCut cut_;
	bool is_ambiguous_ = false; // a face of the cell is cut more than once, or the faces gave several loops
	std::vector<glm::dvec2> seen_;
	std::vector<Edge> edges_;
};

} // namespace vp::mesh
