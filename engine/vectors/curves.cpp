#include "vectors/curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::vectors
{

namespace
{

constexpr double kPieceTurn = 10.0 * std::numbers::pi / 180.0; // smooth where lit, and few
constexpr int kMaxPieces = 32;
// A cubic whose velocities are longer than three chords may run in loops.
constexpr double kMaxChords = 3.0;

double angle(const Vec3& a, const Vec3& b)
{
	return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

bool isDirection(const Vec3& v)
{
	const double length = glm::length(v);
	return std::isfinite(length) && length > 0.0;
}

Vec3 orthogonal(const Vec3& direction)
{
	const Vec3 other = std::abs(direction.x) < 0.7 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
	return glm::normalize(glm::cross(direction, other));
}

// One step of a trace as a cubic in s from 0 to 1 (Hermite's form).
struct Step
{
	Vec3 from, to;      // apart
	Vec3 leave, arrive; // derivatives at the ends

	Step(const Vec3& a, const Vec3& b, const Vec3& velocity_a, const Vec3& velocity_b, double time)
	    : from(a), to(b), leave(derivative(velocity_a, time)), arrive(derivative(velocity_b, time))
	{
	}

	Vec3 at(double s) const
	{
		const double t = 1.0 - s;
		return t * t * (1.0 + 2.0 * s) * from + s * s * (3.0 - 2.0 * s) * to + s * t * (t * leave - s * arrive);
	}
	Vec3 direction(double s) const
	{
		const double t = 1.0 - s;
		const Vec3 along = 6.0 * s * t * (to - from) + t * (1.0 - 3.0 * s) * leave + s * (3.0 * s - 2.0) * arrive;
		return glm::normalize(isDirection(along) ? along : to - from);
	}
	int pieces() const
	{
		const double turn = angle(leave, to - from) + angle(to - from, arrive);
		return std::clamp(static_cast<int>(std::ceil(turn / kPieceTurn)), 1, kMaxPieces);
	}

private:
	Vec3 derivative(const Vec3& velocity, double time) const
	{
		const Vec3 chord = to - from;
		const Vec3 moved = velocity * time;
		if (!isDirection(moved))
			return chord;
		return moved * std::min(1.0, kMaxChords * glm::length(chord) / glm::length(moved));
	}
};

class CurveMaker
{
public:
	CurveMaker(const Traces& traces, std::span<const Vec3> velocities, double least)
	    : traces_(traces), velocities_(velocities), least_(least)
	{
	}

	Curves make()
	{
		for (std::size_t t = 0; t < traces_.count(); ++t)
			addTrace(t);
		return std::move(curves_);
	}

private:
	void addTrace(std::size_t trace)
	{
		const std::size_t first = traces_.first(trace);
		const std::size_t end = first + traces_.size(trace);
		const std::size_t begin = curves_.points.size();
		std::size_t launch = begin;
		for (std::size_t b = first + 1; b < end; ++b)
		{
			const bool is_launch = traces_.launches[trace] == b;
			if (traces_.points[b] != traces_.points[b - 1])
				addStep(b - 1, curves_.points.size() == begin, is_launch || b + 1 == end);
			if (is_launch && curves_.points.size() > begin)
				launch = curves_.points.size() - 1;
		}
		if (curves_.points.size() == begin)
			return;
		curves_.starts.push_back(static_cast<std::uint32_t>(curves_.points.size()));
		curves_.launches.push_back(static_cast<std::uint32_t>(launch));
	}

	// From a point to the next. must: that is not left out.
	void addStep(std::size_t a, bool is_first, bool must)
	{
		const std::size_t b = a + 1;
		const Step step(traces_.points[a], traces_.points[b], velocities_[a], velocities_[b],
		                traces_.times[b] - traces_.times[a]);
		const int pieces = step.pieces();
		if (is_first)
			addPoint(step.from, step.direction(0.0), a, 0.0);
		for (int i = 1; i <= pieces; ++i)
		{
			const double s = static_cast<double>(i) / pieces;
			const Vec3 point = i == pieces ? step.to : step.at(s);
			const Vec3 direction = step.direction(s);
			if ((must && i == pieces) || isWorthIt(point, direction))
				addPoint(point, direction, a, s);
		}
	}

	bool isWorthIt(const Vec3& point, const Vec3& direction) const
	{
		const double far = glm::length(point - curves_.points.back());
		return far > 0.0 && (far >= least_ || angle(direction, curves_.directions.back()) > kPieceTurn);
	}

	void addPoint(const Vec3& point, const Vec3& direction, std::size_t trace_point, double part)
	{
		curves_.points.push_back(point);
		curves_.directions.push_back(direction);
		curves_.trace_points.push_back(static_cast<std::uint32_t>(trace_point));
		curves_.parts.push_back(part);
	}

	const Traces& traces_;
	std::span<const Vec3> velocities_;
	double least_;
	Curves curves_;
};

// Mirrors at the plane with that normal, of any length.
Vec3 mirrored(const Vec3& v, const Vec3& normal)
{
	const double square = glm::dot(normal, normal);
	return square > 0.0 ? v - (2.0 * glm::dot(v, normal) / square) * normal : v;
}

// From one point of a curve to its neighbor.
Vec3 carried(const Vec3& across, const Curves& curves, std::size_t from, std::size_t to)
{
	const Vec3 chord = curves.points[to] - curves.points[from];
	const Vec3 across_half = mirrored(across, chord);
	const Vec3 direction_half = mirrored(curves.directions[from], chord);
	const Vec3 direction = curves.directions[to];
	const Vec3 whole = mirrored(across_half, direction - direction_half);
	const Vec3 square = whole - glm::dot(whole, direction) * direction; // rounding adds up
	return isDirection(square) ? glm::normalize(square) : orthogonal(direction);
}

} // namespace

Curves curvesOf(const Traces& traces, std::span<const Vec3> velocities, double least)
{
	return CurveMaker(traces, velocities, least).make();
}

std::vector<double> alongCurves(const Curves& curves, std::span<const double> at_trace_points)
{
	std::vector<double> values;
	values.reserve(curves.points.size());
	for (std::size_t i = 0; i < curves.points.size(); ++i)
	{
		const std::uint32_t point = curves.trace_points[i];
		const double part = curves.parts[i];
		const double here = at_trace_points[point];
		values.push_back(part > 0.0 ? (1.0 - part) * here + part * at_trace_points[point + 1] : here);
	}
	return values;
}

std::vector<Vec3> directionsAcross(const Curves& curves, std::size_t curve, const Vec3& wished)
{
	const std::size_t first = curves.starts[curve];
	const std::size_t end = curves.starts[curve + 1];
	const std::size_t launch = curves.launches[curve];
	const Vec3 direction = curves.directions[launch];
	const Vec3 square = wished - glm::dot(wished, direction) * direction;
	std::vector<Vec3> across(end - first);
	// Nearly along the curve it says nothing.
	constexpr double kAlong = 1e-3;
	across[launch - first] =
	    glm::length(square) > kAlong * glm::length(wished) ? glm::normalize(square) : orthogonal(direction);
	for (std::size_t i = launch; i + 1 < end; ++i)
		across[i + 1 - first] = carried(across[i - first], curves, i, i + 1);
	for (std::size_t i = launch; i > first; --i)
		across[i - 1 - first] = carried(across[i - first], curves, i, i - 1);
	return across;
}

} // namespace vp::vectors
