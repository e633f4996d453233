#pragma once

#include "measure/plane_lines.h"
#include "measure/plane_triangles.h"

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace vp::measure
{

// Where the values of a sheet's triangles pass given levels: contour lines, and the areas between two levels. A value
// at a level counts as above it, so that lines through vertices are whole, and each is there once.
class Contours
{
public:
	static constexpr std::size_t kNoLevel = std::numeric_limits<std::size_t>::max();

	// levels: ascending. The triangles outlive it.
	Contours(const PlaneTriangles& triangles, std::vector<double> levels);

	// Higher values lie on the left. Open lines end at the rim of the triangles.
	std::vector<PlaneLine> lines(std::size_t level) const;

	// The outlines of where levels[from] <= value < levels[to], kNoLevel being no bound, as closed lines: the area is
	// where they wind around a place at least once (the nonzero rule). No line runs within the area, so it can be
	// filled without seams.
	std::vector<PlaneLine> area(std::size_t from, std::size_t to) const;

private:
	struct Bounds;

	glm::dvec2 crossing(std::uint64_t edge, double level) const;
	void addRim(const NetEdge& edge, const Bounds& bounds, std::vector<PlaneStep>& steps) const;

	const PlaneTriangles& triangles_;
	std::vector<double> levels_;
	std::vector<std::vector<PlaneStep>> steps_; // per level, from edge to edge
	std::vector<NetEdge> rim_;
};

// The outlines of triangles, as Contours::area().
std::vector<PlaneLine> outlinesOf(const std::vector<glm::dvec2>& points, std::span<const PlaneTriangle> triangles);

} // namespace vp::measure
