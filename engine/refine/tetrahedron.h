#pragma once

#include "base/vec.h"
#include "grid/curved/curved_cells.h"
#include "refine/part_list.h"
#include "surface/plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace vp::refine
{

/// The edges of a tetrahedron, in the order of the nodes on those of a quadratic one.
inline constexpr std::array<std::array<std::uint8_t, 2>, 6> kEdges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
inline constexpr std::array<std::array<std::uint8_t, 4>, 4> kEdgeBetween{
    {{0, 0, 2, 3}, {0, 0, 1, 4}, {2, 1, 0, 5}, {3, 4, 5, 0}}};
/// The other two corners.
inline constexpr std::array<std::array<std::uint8_t, 2>, 6> kAcross{{{2, 3}, {0, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}}};

/// A node of a quadratic tetrahedron with `Values` values that are shown, as a share of what they may be off.
template <int Values>
struct Node
{
	std::array<double, 3 + Values> at{}; // x, y, z and the values
	Vec3 place;                          // in the cell's own coordinates
	double priority = -1.0;              // error of a node on an edge that must be halved
	std::uint32_t number = 0;            // number of a corner in the list of parts
	std::uint8_t support = 0;            // a bit for each corner of the cell that the place depends on

	Vec3 position() const { return {at[0], at[1], at[2]}; }
};

/// The positions of a cell's nodes.
using Positions = std::array<Vec3, grid::kQuadraticTetraNodes>;

/// False where a plane misses the control points of a tetrahedron, and so all that it holds. slack: what counts as met
/// beside the plane, since control points are rounded. at(node): its position.
template <class At>
bool mayMeetPlane(const surface::Plane& plane, double slack, At&& at)
{
	std::array<double, 4> corner;
	for (int i = 0; i < 4; ++i)
		corner[i] = plane.signedDistance(at(i));
	double lo = std::min({corner[0], corner[1], corner[2], corner[3]});
	double hi = std::max({corner[0], corner[1], corner[2], corner[3]});
	const auto isMet = [&] { return lo <= slack && hi >= -slack; };
	for (int e = 0; e < 6 && !isMet(); ++e)
	{
		const double control =
		    2.0 * plane.signedDistance(at(4 + e)) - 0.5 * (corner[kEdges[e][0]] + corner[kEdges[e][1]]);
		lo = std::min(lo, control);
		hi = std::max(hi, control);
	}
	return isMet();
}

/// Refines quadratic tetrahedra where planes meet them. An edge is halved as long as its middle is off by more than the
/// tolerance: first the one of a tetrahedron's edges that is off most. Both questions depend on nothing but the
/// edge's own nodes, and new nodes in a face on nothing but the face's nodes, to the last bit. So cells that share a
/// face or an edge cut it alike, though neither looks at the other.
template <int Values>
class TetrahedronRefiner
{
public:
	/// tolerance: what a part may be off, as a share of the cell's size. reach: the largest absolute coordinate.
	TetrahedronRefiner(std::span<const surface::Plane> planes, double tolerance, double reach, PartList& parts)
	    : planes_(planes), tolerance_(tolerance), least_(1e-14 * reach), parts_(parts)
	{
		for (const surface::Plane& plane : planes)
			reach = std::max(reach, glm::length(plane.origin()));
		slack_ = 1e-12 * reach;
	}

	/// Returns false if the planes miss the cell. ids: of its nodes, in the file. addValues(id, node): called for the
	/// nodes of a cell that is met. Throws TooManyParts past kMaxPartsOfCell.
	template <class AddValues>
	bool refine(std::uint32_t cell, const Positions& at,
	            const std::array<std::uint32_t, grid::kQuadraticTetraNodes>& ids, AddValues&& addValues);

private:
	// Places in nodes_.
	using Tetrahedron = std::array<std::uint32_t, grid::kQuadraticTetraNodes>;

	// Six steps halve all edges, which leaves a quarter of what is off. So this is never reached.
	static constexpr int kMaxDepth = 400;

	void measureCell();
	void prioritize(Node<Values>& middle, const Node<Values>& a, const Node<Values>& b) const;
	bool mayMeet(const Tetrahedron& tetrahedron) const;
	bool meets(const Tetrahedron& tetrahedron) const;
	int edgeToHalve(const Tetrahedron& tetrahedron) const;
	std::uint32_t addHalf(std::uint32_t kept, std::uint32_t middle, std::uint32_t dropped);
	std::uint32_t addInFace(const Tetrahedron& t, int edge, int across);
	void refine(const Tetrahedron& tetrahedron, int depth);

	std::span<const surface::Plane> planes_;
	double tolerance_;
	double least_; // allowed where the tolerance is less than rounding
	PartList& parts_;

	std::uint32_t cell_ = 0;
	std::size_t steps_ = 0; // for this cell
	std::vector<Node<Values>> nodes_;
	std::array<double, 16> allowed_{}; // by support: the square of what an edge's middle may be off
	double slack_;
};

// For a quadratic function the error within a tetrahedron is at most 3/2 of the largest error of a middle.
inline constexpr double kShareOfEdge = 2.0 / 3.0;

template <int Values>
void TetrahedronRefiner<Values>::measureCell()
{
	std::array<double, 6> sizes;
	for (std::size_t e = 0; e < 6; ++e)
	{
		const Vec3 a = nodes_[kEdges[e][0]].position();
		const Vec3 b = nodes_[kEdges[e][1]].position();
		const Vec3 middle = nodes_[4 + e].position();
		sizes[e] = std::max(glm::length(a - b), glm::length(middle - 0.5 * (a + b)));
	}
	for (unsigned support = 0; support < 16; ++support)
	{
		double size = 0.0;
		for (std::size_t e = 0; e < 6; ++e)
			if ((support >> kEdges[e][0] & 1) && (support >> kEdges[e][1] & 1))
				size = std::max(size, sizes[e]);
		const double allowed = std::max(kShareOfEdge * tolerance_ * size, least_);
		allowed_[support] = allowed * allowed;
	}
}

template <int Values>
void TetrahedronRefiner<Values>::prioritize(Node<Values>& middle, const Node<Values>& a, const Node<Values>& b) const
{
	const auto off = [&](std::size_t i) { return middle.at[i] - 0.5 * (a.at[i] + b.at[i]); };
	const double geometry = off(0) * off(0) + off(1) * off(1) + off(2) * off(2);
	double values = 0.0;
	for (std::size_t i = 3; i < 3 + Values; ++i)
		values += off(i) * off(i);
	// Halving what is infinite would have no end.
	const auto share = [](double square, double allowed)
	{ return std::isfinite(square / allowed) ? square / allowed : 0.0; };
	const double most = std::max(share(geometry, allowed_[middle.support]), share(values, kShareOfEdge * kShareOfEdge));
	middle.priority = most > 1.0 ? most : -1.0;
}

template <int Values>
bool TetrahedronRefiner<Values>::mayMeet(const Tetrahedron& t) const
{
	return std::ranges::any_of(
	    planes_, [&](const surface::Plane& plane)
	    { return mayMeetPlane(plane, slack_, [&](int node) { return nodes_[t[node]].position(); }); });
}

/// Returns true if the linear part meets a plane. Parts that only touch a plane count, so both cells of a face in the
/// plane are there.
template <int Values>
bool TetrahedronRefiner<Values>::meets(const Tetrahedron& t) const
{
	return std::ranges::any_of(planes_,
	                           [&](const surface::Plane& plane)
	                           {
		                           bool above = false;
		                           bool below = false;
		                           for (std::size_t i = 0; i < 4; ++i)
		                           {
			                           const double distance = plane.signedDistance(nodes_[t[i]].position());
			                           above |= distance >= 0.0;
			                           below |= distance <= 0.0;
		                           }
		                           return above && below;
	                           });
}

/// The one that is off most, and of several the first by the place of its middle; -1 if none has to be halved.
template <int Values>
int TetrahedronRefiner<Values>::edgeToHalve(const Tetrahedron& t) const
{
	int best = -1;
	for (int e = 0; e < 6; ++e)
	{
		const Node<Values>& middle = nodes_[t[4 + e]];
		if (middle.priority < 0.0)
			continue;
		if (best < 0)
		{
			best = e;
			continue;
		}
		const Node<Values>& other = nodes_[t[4 + best]];
		if (middle.priority > other.priority || (middle.priority == other.priority && middle.at < other.at))
			best = e;
	}
	return best;
}

/// The middle of the half from `kept` to the middle of an edge.
template <int Values>
std::uint32_t TetrahedronRefiner<Values>::addHalf(std::uint32_t kept, std::uint32_t middle, std::uint32_t dropped)
{
	const Node<Values>& a = nodes_[kept];
	const Node<Values>& m = nodes_[middle];
	const Node<Values>& b = nodes_[dropped];
	Node<Values> made;
	for (std::size_t i = 0; i < made.at.size(); ++i)
		made.at[i] = 0.375 * a.at[i] + 0.75 * m.at[i] - 0.125 * b.at[i];
	made.place = 0.5 * (a.place + m.place);
	made.support = static_cast<std::uint8_t>(a.support | m.support);
	prioritize(made, a, m);
	nodes_.push_back(made);
	return static_cast<std::uint32_t>(nodes_.size() - 1);
}

/// The middle of the line from a corner to the middle of an edge across.
template <int Values>
std::uint32_t TetrahedronRefiner<Values>::addInFace(const Tetrahedron& t, int edge, int across)
{
	const auto [first, second] = kEdges[edge];
	const Node<Values>& a = nodes_[t[first]];
	const Node<Values>& b = nodes_[t[second]];
	const Node<Values>& c = nodes_[t[across]];
	const Node<Values>& ab = nodes_[t[4 + edge]];
	const Node<Values>& ac = nodes_[t[4 + kEdgeBetween[first][across]]];
	const Node<Values>& bc = nodes_[t[4 + kEdgeBetween[second][across]]];
	Node<Values> made;
	for (std::size_t i = 0; i < made.at.size(); ++i)
		made.at[i] = 0.5 * (ac.at[i] + bc.at[i]) - 0.125 * (a.at[i] + b.at[i]) + 0.25 * ab.at[i];
	made.place = 0.5 * (c.place + ab.place);
	made.support = static_cast<std::uint8_t>(c.support | ab.support);
	prioritize(made, ab, c);
	nodes_.push_back(made);
	return static_cast<std::uint32_t>(nodes_.size() - 1);
}

template <int Values>
void TetrahedronRefiner<Values>::refine(const Tetrahedron& t, int depth)
{
	if (!mayMeet(t))
		return;
	const int edge = edgeToHalve(t);
	if (edge < 0)
	{
		if (meets(t))
			parts_.addPart(
			    grid::kTetra,
			    std::array{nodes_[t[0]].number, nodes_[t[1]].number, nodes_[t[2]].number, nodes_[t[3]].number}, cell_);
		return;
	}
	if (depth > kMaxDepth || ++steps_ > kMaxPartsOfCell)
		throw TooManyParts("the tolerance cannot be met");
	const std::size_t kept = nodes_.size();
	const auto [a, b] = kEdges[edge];
	const auto [c, d] = kAcross[edge];
	const std::uint32_t middle = t[4 + edge];
	Node<Values>& m = nodes_[middle];
	m.number = parts_.between(nodes_[t[a]].number, nodes_[t[b]].number, m.position(), m.place, cell_);
	const std::uint32_t to_c = addInFace(t, edge, c);
	const std::uint32_t to_d = addInFace(t, edge, d);
	for (const auto& [stays, goes] : {std::pair(a, b), std::pair(b, a)})
	{
		Tetrahedron half = t;
		half[goes] = middle;
		half[4 + edge] = addHalf(t[stays], middle, t[goes]);
		half[4 + kEdgeBetween[goes][c]] = to_c;
		half[4 + kEdgeBetween[goes][d]] = to_d;
		refine(half, depth + 1);
	}
	nodes_.resize(kept);
}

template <int Values>
template <class AddValues>
bool TetrahedronRefiner<Values>::refine(std::uint32_t cell, const Positions& at,
                                        const std::array<std::uint32_t, grid::kQuadraticTetraNodes>& ids,
                                        AddValues&& addValues)
{
	static constexpr std::array<Vec3, 4> kCorners{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
	if (std::ranges::none_of(planes_, [&](const surface::Plane& plane)
	                         { return mayMeetPlane(plane, slack_, [&](int node) { return at[node]; }); }))
		return false;
	cell_ = cell;
	steps_ = 0;
	nodes_.resize(at.size());
	for (std::size_t n = 0; n < at.size(); ++n)
	{
		nodes_[n] = {};
		std::copy_n(&at[n].x, 3, nodes_[n].at.begin());
		addValues(ids[n], nodes_[n]);
	}
	measureCell();
	for (std::size_t i = 0; i < 4; ++i)
	{
		nodes_[i].place = kCorners[i];
		nodes_[i].support = static_cast<std::uint8_t>(1 << i);
		nodes_[i].number = parts_.node(ids[i], at[i]);
	}
	for (std::size_t e = 0; e < 6; ++e)
	{
		const Node<Values>& a = nodes_[kEdges[e][0]];
		const Node<Values>& b = nodes_[kEdges[e][1]];
		nodes_[4 + e].place = 0.5 * (a.place + b.place);
		nodes_[4 + e].support = static_cast<std::uint8_t>(a.support | b.support);
		prioritize(nodes_[4 + e], a, b);
	}
	refine({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, 0);
	return true;
}

} // namespace vp::refine
