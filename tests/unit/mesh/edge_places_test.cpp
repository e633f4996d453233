#include "mesh/edge_places.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <random>
#include <utility>
#include <vector>

namespace vp::test
{

namespace
{

using mesh::PlacedFrom;

// Edges with ends on both sides of a plane; now and then an end lies on it.
template <class Number>
struct Edges
{
	std::vector<Number> xyz;
	std::vector<std::array<PointId, 2>> ends;

	Vec3 point(PointId p) const { return {xyz[3 * p], xyz[3 * p + 1], xyz[3 * p + 2]}; }
};

// `from` says which end comes first.
template <class Number>
Edges<Number> randomEdges(const surface::Plane& plane, PlacedFrom from, std::size_t count, std::mt19937& random)
{
	std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
	Edges<Number> edges;
	const auto add = [&]
	{
		const bool on_plane = random() % 8 == 0;
		for (int axis = 0; axis < 3; ++axis)
			edges.xyz.push_back(static_cast<Number>(on_plane ? plane.origin()[axis] : anywhere(random)));
		return static_cast<PointId>(edges.xyz.size() / 3 - 1);
	};
	while (edges.ends.size() < count)
	{
		std::array<PointId, 2> ends{add(), add()};
		const auto isPositive = [&](PointId p) { return plane.signedDistance(edges.point(p)) >= 0.0; };
		if (isPositive(ends[0]) == isPositive(ends[1]))
			continue;
		if (from == PlacedFrom::positive && isPositive(ends[1]))
			std::swap(ends[0], ends[1]);
		edges.ends.push_back(ends);
	}
	return edges;
}

std::array<std::uint64_t, 4> bitsOf(double t, const Vec3& place)
{
	return {std::bit_cast<std::uint64_t>(t), std::bit_cast<std::uint64_t>(place.x),
	        std::bit_cast<std::uint64_t>(place.y), std::bit_cast<std::uint64_t>(place.z)};
}

template <class Number, PlacedFrom kFrom>
void expectSameBits()
{
	std::mt19937 random(5);
	for (const std::size_t count : {0u, 1u, 2u, 7u, 1000u})
	{
		// An origin that float holds too, so that points lie exactly on the plane.
		const surface::Plane plane({0.25, -0.125, 0.5}, {0.3, count == 7u ? 0.0 : -0.7, 0.6});
		const auto edges = randomEdges<Number>(plane, kFrom, count, random);
		std::size_t taken = 0;
		bool any_at_point = false;
		const bool at_points = mesh::EdgePlaces<kFrom>(plane).place(
		    count, [&](std::size_t v) { return mesh::edgeEnds(edges.xyz.data(), edges.ends[v][0], edges.ends[v][1]); },
		    [&](std::size_t v, double t, TwoDoubles xy, double z)
		    {
			    EXPECT_EQ(v, taken++);
			    const Vec3 a = edges.point(edges.ends[v][0]);
			    const Vec3 b = edges.point(edges.ends[v][1]);
			    const double height = plane.signedDistance(a);
			    const double expected = surface::Plane::crossing(height, plane.signedDistance(b));
			    const Vec3 place = kFrom == PlacedFrom::lower
			                           ? mesh::placeOnEdge(a, b, expected)
			                           : mesh::placeOfAnyNumbering(a, b, expected, height >= 0.0);
			    EXPECT_EQ(bitsOf(t, {xy[0], xy[1], z}), bitsOf(expected, place));
			    any_at_point = any_at_point || expected == 0.0 || expected == 1.0;
		    });
		EXPECT_EQ(taken, count);
		EXPECT_EQ(at_points, any_at_point);
	}
}

} // namespace

TEST(EdgePlaces, AreThoseOfOneEdgeAloneToTheLastBit)
{
	expectSameBits<float, PlacedFrom::lower>();
	expectSameBits<double, PlacedFrom::lower>();
	expectSameBits<float, PlacedFrom::positive>();
	expectSameBits<double, PlacedFrom::positive>();
}

} // namespace vp::test
