#pragma once

#include "cases/case_table.h"
#include "cases/cell_walk.h"
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
// case table where it has an entry, by walking the cell's faces otherwise. Reused from cell to cell to save
// allocations.
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

	// What the table knows of a cut cell; null where its faces are to be walked.
	const cases::Case* entryOf(CellId cell, std::uint32_t code) const
	{
		const grid::CellShape shape = grid_.shape(cell);
		if (shape == grid::CellShape::polyhedron)
			return nullptr;
		const cases::Case& entry = tables_[static_cast<std::size_t>(shape)][code & 0xFFu];
		return entry.needs_walk ? nullptr : &entry;
	}

	// Calls visit(std::span<const Edge>) per polygon. Returns whether the cell is twisted: a face cut more than once,
	// or several polygons.
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
		return cut_.ambiguous || cut_.polygons() > 1;
	}

private:
	void walk(CellId cell)
	{
		grid_.cellFaces(cell, faces_);
		local_points_ = faces_.points;
		std::sort(local_points_.begin(), local_points_.end());
		local_points_.erase(std::unique(local_points_.begin(), local_points_.end()), local_points_.end());
		distances_.clear();
		positive_.clear();
		for (const PointId p : local_points_)
		{
			distances_.push_back(surface::heightAt(grid_, surface_, p));
			positive_.push_back(distances_.back() >= 0.0);
		}
		walk_faces_.points.clear();
		walk_faces_.starts = faces_.starts;
		for (const PointId p : faces_.points)
			walk_faces_.points.push_back(static_cast<std::uint16_t>(
			    std::lower_bound(local_points_.begin(), local_points_.end(), p) - local_points_.begin()));
		// The sum of the distances of a face's points, in ascending order: the same number for both its cells, however
		// points are numbered.
		const auto center_positive = [&](int f)
		{
			face_.clear();
			for (const std::uint16_t p : walk_faces_[f])
				face_.push_back(distances_[p]);
			std::sort(face_.begin(), face_.end());
			double sum = 0.0;
			for (const double distance : face_)
				sum += distance;
			return sum >= 0.0;
		};
		cases::walkCell(walk_faces_, std::span<const std::uint8_t>(positive_), center_positive, cut_);
	}

	const G& grid_;
	const Surface& surface_;
	std::array<const cases::Case*, grid::kTableShapes> tables_;
	grid::CellFaces faces_;
	std::vector<PointId> local_points_; // of the walked cell, ascending
	std::vector<double> distances_;
	std::vector<std::uint8_t> positive_;
	std::vector<double> face_;
	cases::WalkFaces walk_faces_;
	cases::CellCut cut_;
	std::vector<Edge> edges_;
};

} // namespace vp::mesh
