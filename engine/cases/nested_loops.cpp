#include "cases/nested_loops.h"

#include "base/cross2.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace vp::cases
{

namespace
{

using glm::dvec2;

constexpr std::uint32_t kNoLoop = 0xFFFFFFFFu;

// A place that is nearer to a line than this share of the loop's size lies on the line.
constexpr double kOnLoop = 1e-12;

// Largest number of a loop's corners whose places are tested.
constexpr std::size_t kAsked = 16;

// A corner of a loop.
struct Corner
{
	CutEdge edge;
	dvec2 at;
};

struct Loop
{
	std::vector<Corner> corners;
	dvec2 lo{std::numeric_limits<double>::infinity()};
	dvec2 hi{-std::numeric_limits<double>::infinity()};
	double area = 0.0; // twice, above 0 if it runs counter-clockwise

	double size() const { return glm::length(hi - lo); }
	// A surface that only touches a corner of the cell gives a loop without area.
	bool isFlat() const { return std::abs(area) <= kOnLoop * size() * size(); }
	const Corner& after(std::size_t i) const { return corners[i + 1 < corners.size() ? i + 1 : 0]; }
	const Corner& before(std::size_t i) const { return corners[i > 0 ? i - 1 : corners.size() - 1]; }
};

enum class Where
{
	outside,
	inside,
	on_loop
};

Where whereIs(const dvec2& p, const Loop& loop)
{
	bool inside = false;
	for (std::size_t i = 0; i < loop.corners.size(); ++i)
	{
		const dvec2 a = loop.corners[i].at - p;
		const dvec2 b = loop.after(i).at - p;
		const double length = glm::length(b - a);
		const bool beside = glm::dot(a, b) <= 0.0 || glm::length(a) <= kOnLoop * loop.size();
		if (beside && std::abs(cross(a, b)) <= kOnLoop * loop.size() * length)
			return Where::on_loop;
		if ((a.y > 0.0) != (b.y > 0.0) && (cross(a, b) > 0.0) == (b.y > a.y))
			inside = !inside;
	}
	return inside ? Where::inside : Where::outside;
}

bool liesWithin(const Loop& inner, const Loop& outer)
{
	if (!(glm::all(glm::greaterThanEqual(inner.lo, outer.lo)) && glm::all(glm::lessThanEqual(inner.hi, outer.hi))) ||
	    std::abs(inner.area) >= std::abs(outer.area))
		return false;
	bool within = false;
	const std::size_t step = 1 + (inner.corners.size() - 1) / kAsked;
	for (std::size_t i = 0; i < inner.corners.size(); i += step)
		for (const dvec2& p : {inner.corners[i].at, 0.5 * (inner.corners[i].at + inner.after(i).at)})
		{
			const Where where = whereIs(p, outer);
			if (where == Where::outside)
				return false;
			within = within || where == Where::inside;
		}
	return within;
}

// Takes holes into a polygon that runs counter-clockwise, from the left to the right: so the bridge of each leads to
// what is there already (Eberly, "Triangulation by Ear Clipping", 2002).
class Bridges
{
public:
	explicit Bridges(Loop& polygon) : polygon_(polygon) {}

	// The hole runs clockwise.
	void take(const std::vector<Corner>& hole)
	{
		const auto leftmost = std::ranges::min_element(hole, {}, keyOf);
		const std::size_t at = seenFrom(leftmost->at).value_or(nearest(leftmost->at));
		std::vector<Corner> bridged;
		bridged.insert(bridged.end(), leftmost, hole.end());
		bridged.insert(bridged.end(), hole.begin(), leftmost);
		bridged.push_back(*leftmost);
		bridged.push_back(polygon_.corners[at]);
		polygon_.corners.insert(polygon_.corners.begin() + static_cast<std::ptrdiff_t>(at) + 1, bridged.begin(),
		                        bridged.end());
	}

	static std::pair<double, double> keyOf(const Corner& corner) { return {corner.at.x, corner.at.y}; }

private:
	// The corner of the polygon to which a straight line leads from p, with nothing of the polygon between.
	std::optional<std::size_t> seenFrom(const dvec2& p) const
	{
		// The side that a ray to the left meets first, and its end that lies farther to the left: the hole is not
		// there.
		std::optional<std::size_t> end;
		double first = -std::numeric_limits<double>::infinity();
		for (std::size_t i = 0; i < polygon_.corners.size(); ++i)
		{
			const dvec2& a = polygon_.corners[i].at;
			const dvec2& b = polygon_.after(i).at;
			if (!(a.y >= p.y && b.y <= p.y && a.y != b.y)) // its inside is to the right
				continue;
			const double x = a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
			if (!(x <= p.x && x > first))
				continue;
			first = x;
			const std::size_t next = i + 1 < polygon_.corners.size() ? i + 1 : 0;
			end = p.y == a.y ? i : p.y == b.y ? next : a.x < b.x ? i : next;
		}
		if (!end)
			return end;
		const dvec2 met(first, p.y);
		const dvec2 at = polygon_.corners[*end].at;
		if (met == at)
			return end;
		// A corner in the triangle of p, the place met and that end may hide it. The one along the flattest line is
		// seen.
		double flattest = std::numeric_limits<double>::infinity();
		for (std::size_t i = 0; i < polygon_.corners.size(); ++i)
		{
			const dvec2& q = polygon_.corners[i].at;
			if (q == at || q.x > p.x || !holds(p, met, at, q) || !opensTo(i, p))
				continue;
			const double slope = q == p ? -1.0 : std::abs(q.y - p.y) / (p.x - q.x);
			if (slope < flattest || (slope == flattest && q.x > polygon_.corners[*end].at.x))
			{
				flattest = slope;
				end = i;
			}
		}
		return end;
	}

	static bool holds(const dvec2& a, const dvec2& b, const dvec2& c, const dvec2& q)
	{
		const double u = cross(b - a, q - a);
		const double v = cross(c - b, q - b);
		const double w = cross(a - c, q - c);
		return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
	}

	// Returns true if p is on the inner side of the two sides at a corner.
	bool opensTo(std::size_t i, const dvec2& p) const
	{
		const dvec2& q = polygon_.corners[i].at;
		const dvec2 from = q - polygon_.before(i).at;
		const dvec2 to = polygon_.after(i).at - q;
		const bool left_of_from = cross(from, p - q) >= 0.0;
		const bool left_of_to = cross(to, p - q) >= 0.0;
		return cross(from, to) >= 0.0 ? left_of_from && left_of_to : left_of_from || left_of_to;
	}

	// For what rounding, or a polygon that crosses itself, leaves without one that is seen.
	std::size_t nearest(const dvec2& p) const
	{
		const auto distance = [&](const Corner& corner) { return glm::distance(corner.at, p); };
		return static_cast<std::size_t>(std::ranges::min_element(polygon_.corners, {}, distance) -
		                                polygon_.corners.begin());
	}

	Loop& polygon_;
};

std::vector<Loop> loopsOf(const CellCut& cut, std::span<const dvec2> places)
{
	std::vector<Loop> loops(static_cast<std::size_t>(cut.polygons()));
	for (std::size_t l = 0; l < loops.size(); ++l)
	{
		Loop& loop = loops[l];
		for (std::uint32_t e = cut.starts[l]; e < cut.starts[l + 1]; ++e)
		{
			loop.corners.push_back({cut.edges[e], places[e]});
			loop.lo = glm::min(loop.lo, places[e]);
			loop.hi = glm::max(loop.hi, places[e]);
		}
		const dvec2& origin = loop.corners.front().at;
		for (std::size_t i = 1; i + 1 < loop.corners.size(); ++i)
			loop.area += cross(loop.corners[i].at - origin, loop.corners[i + 1].at - origin);
	}
	return loops;
}

// Per loop the one of which it is a hole, or kNoLoop.
std::vector<std::uint32_t> findHoles(const std::vector<Loop>& loops)
{
	const auto count = static_cast<std::uint32_t>(loops.size());
	std::vector<std::vector<std::uint32_t>> around(count);
	for (std::uint32_t i = 0; i < count; ++i)
		for (std::uint32_t j = 0; j < count && !loops[i].isFlat(); ++j)
			if (j != i && !loops[j].isFlat() && liesWithin(loops[i], loops[j]))
				around[i].push_back(j);
	std::vector<std::uint32_t> hole_of(count, kNoLoop);
	for (std::uint32_t i = 0; i < count; ++i)
		if (around[i].size() % 2 == 1)
			for (const std::uint32_t j : around[i])
				if (around[j].size() + 1 == around[i].size())
					hole_of[i] = j;
	return hole_of;
}

} // namespace

void joinNestedLoops(CellCut& cut, std::span<const dvec2> places)
{
	if (cut.polygons() < 2 || cut.polygons() > kMaxLoops)
		return;
	std::vector<Loop> loops = loopsOf(cut, places);
	const std::vector<std::uint32_t> hole_of = findHoles(loops);
	if (std::ranges::all_of(hole_of, [](std::uint32_t outer) { return outer == kNoLoop; }))
		return;
	cut.edges.clear();
	cut.starts.assign(1, 0);
	for (std::uint32_t l = 0; l < loops.size(); ++l)
	{
		if (hole_of[l] != kNoLoop)
			continue;
		Loop& outer = loops[l];
		std::vector<Loop*> holes;
		for (std::uint32_t h = 0; h < loops.size(); ++h)
			if (hole_of[h] == l)
				holes.push_back(&loops[h]);
		// Seen from behind, what runs clockwise runs counter-clockwise.
		const bool clockwise = outer.area < 0.0;
		const auto mirror = [&](Loop& loop)
		{
			for (Corner& corner : loop.corners)
				corner.at.x = clockwise ? -corner.at.x : corner.at.x;
		};
		mirror(outer);
		for (Loop* hole : holes)
		{
			mirror(*hole);
			if ((hole->area < 0.0) == clockwise)
				std::ranges::reverse(hole->corners);
		}
		const auto leftmost = [](const Loop* hole)
		{ return Bridges::keyOf(*std::ranges::min_element(hole->corners, {}, Bridges::keyOf)); };
		std::ranges::sort(holes, {}, leftmost);
		Bridges bridges(outer);
		for (const Loop* hole : holes)
			bridges.take(hole->corners);
		for (const Corner& corner : outer.corners)
			cut.edges.push_back(corner.edge);
		cut.starts.push_back(static_cast<std::uint32_t>(cut.edges.size()));
	}
}

} // namespace vp::cases
