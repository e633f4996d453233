#include "measure/overlap.h"

#include "base/cross2.h"
#include "measure/plane_triangles.h"
#include "mesh/polygon_fans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace vp::measure
{

namespace
{

using Place = glm::dvec2;

struct Rect
{
	Place lo;
	Place hi;

	bool meets(const Rect& other) const
	{
		return lo.x < other.hi.x && other.lo.x < hi.x && lo.y < other.hi.y && other.lo.y < hi.y;
	}
};

// A triangle that runs counter-clockwise.
struct Triangle
{
	std::array<Place, 3> corners;
	Rect rect;
	std::uint32_t input;
};

// Returns the area that two triangles have in common, by Sutherland and Hodgman.
double commonArea(const Triangle& a, const Triangle& b)
{
	std::array<Place, 9> part; // a side more for each side that clips
	std::array<Place, 9> next;
	std::size_t corners = 3;
	std::ranges::copy(a.corners, part.begin());
	for (std::size_t side = 0; side < 3 && corners > 0; ++side)
	{
		const Place from = b.corners[side];
		const Place way = b.corners[(side + 1) % 3] - from;
		std::size_t kept = 0;
		for (std::size_t i = 0; i < corners; ++i)
		{
			const Place& at = part[i];
			const Place& after = part[(i + 1) % corners];
			const double inside = cross(way, at - from);
			const double inside_after = cross(way, after - from);
			if (inside >= 0.0)
				next[kept++] = at;
			if ((inside > 0.0 && inside_after < 0.0) || (inside < 0.0 && inside_after > 0.0))
				next[kept++] = at + inside / (inside - inside_after) * (after - at);
		}
		corners = kept;
		part = next;
	}
	double area = 0.0;
	for (std::size_t i = 1; i + 1 < corners; ++i)
		area += 0.5 * cross(part[i] - part[0], part[i + 1] - part[0]);
	return area;
}

// The inputs that share room with another.
std::vector<bool> meetingInputs(const grid::BlockSet& blocks)
{
	std::map<std::uint32_t, Box> bounds;
	for (const grid::Block& block : blocks.blocks)
		bounds[block.input].include(block.bounds);
	std::vector<bool> meets(bounds.empty() ? 0 : bounds.rbegin()->first + 1);
	for (auto a = bounds.begin(); a != bounds.end(); ++a)
		for (auto b = std::next(a); b != bounds.end(); ++b)
		{
			const Vec3 room = glm::min(a->second.hi, b->second.hi) - glm::max(a->second.lo, b->second.lo);
			if (room.x > 0.0 && room.y > 0.0 && room.z > 0.0)
				meets[a->first] = meets[b->first] = true;
		}
	return meets;
}

std::vector<Triangle> trianglesOf(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const probe::Frame& frame,
                                  const std::vector<bool>& meets)
{
	const std::vector<Place> points = planePoints(mesh, frame);
	std::vector<Triangle> triangles;
	std::vector<Place> places;
	for (std::size_t p = 0; p < mesh.polygons() - mesh.boundary_polygons; ++p)
	{
		const std::uint32_t input = blocks.blocks[mesh.polygon_cells[p].block].input;
		if (!meets[input])
			continue;
		places.clear();
		for (const std::uint32_t v : mesh.polygon(p))
			places.push_back(points[v]);
		for (const std::vector<std::uint32_t>& fan : mesh::cutIntoFans(places))
			for (std::size_t i = 1; i + 1 < fan.size(); ++i)
			{
				const Place &a = places[fan[0]], &b = places[fan[i]], &c = places[fan[i + 1]];
				if (cross(b - a, c - a) > 0.0)
					triangles.push_back({{a, b, c}, {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))}, input});
			}
	}
	return triangles;
}

// Triangles in bins over the plane: some two a bin.
class Bins
{
public:
	explicit Bins(const std::vector<Triangle>& triangles) : triangles_(triangles)
	{
		for (const Triangle& triangle : triangles)
			rect_ = {glm::min(rect_.lo, triangle.rect.lo), glm::max(rect_.hi, triangle.rect.hi)};
		side_ = std::max(1, static_cast<int>(std::sqrt(0.5 * static_cast<double>(triangles.size()))));
		bins_.resize(static_cast<std::size_t>(side_) * side_);
		for (std::uint32_t t = 0; t < triangles.size(); ++t)
		{
			const glm::ivec2 lo = binOf(triangles[t].rect.lo), hi = binOf(triangles[t].rect.hi);
			for (int y = lo.y; y <= hi.y; ++y)
				for (int x = lo.x; x <= hi.x; ++x)
					bins_[static_cast<std::size_t>(y) * side_ + x].push_back(t);
		}
	}

	// visit(a, b) for each two triangles of different inputs whose rectangles meet, once.
	template <class Visit>
	void forPairs(Visit&& visit) const
	{
		for (std::size_t bin = 0; bin < bins_.size(); ++bin)
			for (const std::uint32_t t : bins_[bin])
				for (const std::uint32_t other : bins_[bin])
				{
					const Triangle &a = triangles_[t], &b = triangles_[other];
					// Both may be in several bins. The one where their common rectangle begins counts.
					if (a.input < b.input && a.rect.meets(b.rect) &&
					    numberOf(binOf(glm::max(a.rect.lo, b.rect.lo))) == bin)
						visit(a, b);
				}
	}

private:
	glm::ivec2 binOf(const Place& place) const
	{
		const Place part = (place - rect_.lo) / glm::max(rect_.hi - rect_.lo, Place(1e-300));
		return glm::clamp(glm::ivec2(part * double(side_)), glm::ivec2(0), glm::ivec2(side_ - 1));
	}
	std::size_t numberOf(const glm::ivec2& bin) const { return static_cast<std::size_t>(bin.y) * side_ + bin.x; }

	const std::vector<Triangle>& triangles_;
	Rect rect_{Place(1e300), Place(-1e300)};
	int side_ = 1;
	std::vector<std::vector<std::uint32_t>> bins_;
};

} // namespace

Overlap overlapOf(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const probe::Frame& frame)
{
	const std::vector<bool> meets = meetingInputs(blocks);
	if (std::ranges::count(meets, true) < 2)
		return {};
	const std::vector<Triangle> triangles = trianglesOf(blocks, mesh, frame, meets);
	std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;
	Bins(triangles).forPairs(
	    [&](const Triangle& a, const Triangle& b) {
		    areas[{a.input, b.input}] += commonArea(a, b);
	    });
	Overlap overlap;
	double most = 0.0;
	for (const auto& [inputs, area] : areas)
	{
		overlap.area += area;
		if (area > most)
			overlap.inputs = inputs;
		most = std::max(most, area);
	}
	double all = 0.0;
	for (std::size_t p = 0; p < mesh.polygons() - mesh.boundary_polygons; ++p)
		all += 0.5 * glm::length(mesh::doubleArea(mesh, mesh.polygon(p)));
	overlap.share = all > 0.0 ? overlap.area / all : 0.0;
	return overlap;
}

} // namespace vp::measure
