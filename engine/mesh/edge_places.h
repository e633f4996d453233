#pragma once

#include "base/ids.h"
#include "base/two_doubles.h"
#include "mesh/sheet_mesh.h"
#include "surface/plane.h"

#include <cstddef>

namespace vp::mesh
{

// The end a of an edge, from which a vertex's place is computed. The results differ in rounding only.
enum class PlacedFrom
{
	lower,   // the lower point, as placeOnEdge() does
	positive // the point on the positive side, as placeOfAnyNumbering() does
};

// The ends of an edge, a and b.
struct EdgeEnds
{
	TwoDoubles xy_a;
	TwoDoubles xy_b;
	TwoDoubles z; // z of both ends
};

// The same of an edge between points that are kept as numbers.
template <class Number>
EdgeEnds edgeEnds(const Number* xyz, PointId lower, PointId higher)
{
	const Number* a = xyz + 3 * std::size_t(lower);
	const Number* b = xyz + 3 * std::size_t(higher);
	return {loadTwo(a), loadTwo(b), loadTwo(a + 2, b + 2)};
}

// Where a plane cuts edges. Takes two edges at a time, with the same bits as Plane::crossing() and then placeOnEdge()
// or placeOfAnyNumbering() give.
template <PlacedFrom kFrom>
class EdgePlaces
{
public:
	explicit EdgePlaces(const surface::Plane& plane)
	    : origin_xy_{plane.origin().x, plane.origin().y}, normal_xy_{plane.normal().x, plane.normal().y},
	      origin_z_(bothOf(plane.origin().z)), normal_z_(bothOf(plane.normal().z))
	{
	}

	// Places `count` vertices. endsOf(v): the EdgeEnds of vertex v, whose signs differ; a is the end that kFrom names.
	// take(v, part, xy, z) gets the place a + part (b - a). Returns whether one of them is at a grid point.
	template <class EndsOf, class Take>
	bool place(std::size_t count, EndsOf&& endsOf, Take&& take) const
	{
		bool at_points = false;
		std::size_t v = 0;
		for (; v + 1 < count; v += 2)
		{
			const Pair pair = placePair(Edge(*this, endsOf(v)), Edge(*this, endsOf(v + 1)));
			take(v, pair.part[0], pair.first_xy, pair.z[0]);
			take(v + 1, pair.part[1], pair.second_xy, pair.z[1]);
			at_points |= pair.at_point;
		}
		if (v < count)
		{
			const Edge last(*this, endsOf(v));
			const Pair pair = placePair(last, last);
			take(v, pair.part[0], pair.first_xy, pair.z[0]);
			at_points |= pair.at_point;
		}
		return at_points;
	}

private:
	struct Edge : EdgeEnds
	{
		[[gnu::always_inline]] inline Edge(const EdgePlaces& places, const EdgeEnds& ends) : EdgeEnds(ends)
		{
			const TwoDoubles along_a = (xy_a - places.origin_xy_) * places.normal_xy_;
			const TwoDoubles along_b = (xy_b - places.origin_xy_) * places.normal_xy_;
			heights =
			    firstsOf(along_a, along_b) + secondsOf(along_a, along_b) + (z - places.origin_z_) * places.normal_z_;
		}

		TwoDoubles heights; // heights of both ends
	};

	// The places of two vertices.
	struct Pair
	{
		TwoDoubles part;
		TwoDoubles first_xy;
		TwoDoubles second_xy;
		TwoDoubles z;
		bool at_point; // one of them
	};
	[[gnu::always_inline]] static inline Pair placePair(const Edge& first, const Edge& second)
	{
		const TwoDoubles height_a = firstsOf(first.heights, second.heights);
		const TwoDoubles height_b = secondsOf(first.heights, second.heights);
		constexpr bool kPositiveFirst = kFrom == PlacedFrom::positive;
		const TwoDoubles positive = kPositiveFirst ? height_a : greater(height_a, height_b);
		const TwoDoubles negative = kPositiveFirst ? height_b : lesser(height_a, height_b);
		const TwoDoubles from_negative = 1.0 - positive / (positive - negative);
		const TwoDoubles from_positive = 1.0 - from_negative;
		Pair pair;
		pair.part = from_positive;
		if constexpr (!kPositiveFirst)
			pair.part = height_a < height_b ? from_negative : from_positive;
		pair.at_point = isAnyEqual(lesser(from_negative, from_positive), bothOf(0.0));
		pair.first_xy = between(first.xy_a, first.xy_b, firstsOf(pair.part, pair.part), pair.at_point);
		pair.second_xy = between(second.xy_a, second.xy_b, secondsOf(pair.part, pair.part), pair.at_point);
		pair.z = between(firstsOf(first.z, second.z), secondsOf(first.z, second.z), pair.part, pair.at_point);
		return pair;
	}

	// The coordinate of places from those of the ends.
	[[gnu::always_inline]] static inline TwoDoubles between(TwoDoubles a, TwoDoubles b, TwoDoubles part, bool at_point)
	{
		const TwoDoubles place = a + part * (b - a);
		return at_point ? (part == 1.0 ? b : place) : place;
	}

	TwoDoubles origin_xy_;
	TwoDoubles normal_xy_;
	TwoDoubles origin_z_;
	TwoDoubles normal_z_;
};

} // namespace vp::mesh
