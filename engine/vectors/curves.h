#pragma once

#include "vectors/traces.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::vectors
{

// Traces as curves to be drawn. Between two points of a trace, a step apart, runs the cubic that has the particle's
// velocity at both ends, in as many pieces as its bend needs. Traces of no length are left out.
struct Curves
{
	std::vector<std::uint32_t> starts{0}; // curves + 1 offsets into the points
	std::vector<std::uint32_t> launches;  // per curve: the point, among all, where its particle was launched

	// Per point of all curves.
	RawVector<Vec3> points;                // no two neighbors are equal
	RawVector<Vec3> directions;            // unit vectors along which the particle moves
	RawVector<std::uint32_t> trace_points; // the point of the traces it follows, and how far on it is to the next, 0..1
	RawVector<double> parts;

	std::size_t count() const { return starts.size() - 1; }
};

// velocities: of the particles, per point of the traces, in units of length per time of Traces::times. What is not
// finite counts as unknown: the curve is straight there. least: points nearer to the last one than this, and no farther
// turned than a piece may, are left out, but for ends and launches.
Curves curvesOf(const Traces& traces, std::span<const Vec3> velocities, double least = 0.0);

// Values at the traces' points as values at the curves' points, linear between two.
std::vector<double> alongCurves(const Curves& curves, std::span<const double> at_trace_points);

// A direction across the curve at each of a curve's points, of unit length, that turns about the curve no more than it
// must (Wang, Juettler, Zheng, Liu, "Computation of Rotation Minimizing Frames", 2008: double reflection). At the
// launch it is as near to `wished` as it can be.
std::vector<Vec3> directionsAcross(const Curves& curves, std::size_t curve, const Vec3& wished);

} // namespace vp::vectors
