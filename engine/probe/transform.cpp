#include "probe/transform.h"

#include <cmath>
#include <numbers>

namespace vp::probe
{

namespace
{

// Returns true if the vectors have unit length and are at right angles, within rounding.
bool isFrame(const Vec3& normal, const Vec3& up)
{
	constexpr double kRounding = 1e-15;
	return std::abs(glm::dot(normal, normal) - 1.0) < kRounding && std::abs(glm::dot(up, up) - 1.0) < kRounding &&
	       std::abs(glm::dot(normal, up)) < kRounding;
}

struct Turn
{
	double cosine;
	double sine;
};

Turn turnOf(double degrees)
{
	const double rest = std::remainder(degrees, 90.0); // exact
	const double quarters = std::round((degrees - rest) / 90.0);
	const double c = std::cos(rest * std::numbers::pi / 180.0);
	const double s = std::sin(rest * std::numbers::pi / 180.0);
	switch (static_cast<int>(quarters - 4.0 * std::floor(quarters / 4.0)))
	{
	case 0:
		return {c, s};
	case 1:
		return {-s, c};
	case 2:
		return {-c, -s};
	default:
		return {s, -c};
	}
}

} // namespace

glm::dmat4 Transform::glmMatrix() const
{
	return {glm::dvec4(row[0], 0.0), glm::dvec4(row[1], 0.0), glm::dvec4(row[2], 0.0), glm::dvec4(row[3], 1.0)};
}

Transform operator*(const Transform& a, const Transform& b)
{
	return {{b.vector(a.row[0]), b.vector(a.row[1]), b.vector(a.row[2]), b.point(a.row[3])}};
}

Transform inverse(const Transform& transform)
{
	const auto& row = transform.row;
	const glm::dmat3 linear = glm::inverse(glm::dmat3(row[0], row[1], row[2]));
	Transform back{{linear[0], linear[1], linear[2], Vec3(0.0)}};
	back.row[3] = -back.vector(row[3]);
	return back;
}

// Scaled by the largest component first: the square of a very long or very short one is no number.
Vec3 unitVector(const Vec3& v)
{
	const Vec3 magnitude = glm::abs(v);
	return glm::normalize(v / std::max({magnitude.x, magnitude.y, magnitude.z}));
}

Frame makeFrame(const Vec3& origin, const Vec3& normal, const Vec3& up)
{
	if (isFrame(normal, up))
		return {origin, normal, up};
	Frame frame;
	frame.origin = origin;
	frame.normal = unitVector(normal);
	for (const Vec3& candidate : std::array<Vec3, 3>{up, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}})
	{
		if (candidate == Vec3(0.0))
			continue;
		const Vec3 direction = unitVector(candidate);
		const Vec3 flat = direction - glm::dot(direction, frame.normal) * frame.normal;
		if (glm::length(flat) > 1e-6)
		{
			// Twice: what is left along the normal grew with the division.
			const Vec3 once = glm::normalize(flat);
			frame.up = glm::normalize(once - glm::dot(once, frame.normal) * frame.normal);
			break;
		}
	}
	return frame;
}

Transform toFrame(const Frame& frame)
{
	const Vec3 x = frame.xAxis();
	const Vec3& y = frame.up;
	const Vec3& z = frame.normal;
	const Vec3 origin{glm::dot(frame.origin, x), glm::dot(frame.origin, y), glm::dot(frame.origin, z)};
	return {{Vec3(x.x, y.x, z.x), Vec3(x.y, y.y, z.y), Vec3(x.z, y.z, z.z), -origin}};
}

Transform fromFrame(const Frame& frame)
{
	return {{frame.xAxis(), frame.up, frame.normal, frame.origin}};
}

Frame placed(const Frame& frame, const Frame& holder)
{
	const Transform out = fromFrame(holder);
	return makeFrame(out.point(frame.origin), out.vector(frame.normal), out.vector(frame.up));
}

Frame turned(const Frame& frame, const Vec3& through, const Vec3& axis, double degrees)
{
	const Turn turn = turnOf(degrees);
	const Vec3 a = unitVector(axis);
	// Rodrigues' formula.
	const auto turnedVector = [&](const Vec3& v)
	{ return turn.cosine * v + turn.sine * glm::cross(a, v) + (1.0 - turn.cosine) * glm::dot(a, v) * a; };
	const Vec3 arm = frame.origin - through;
	// A frame about its own origin stays there to the last bit.
	const Vec3 origin = arm == Vec3(0.0) ? frame.origin : through + turnedVector(arm);
	return makeFrame(origin, turnedVector(frame.normal), turnedVector(frame.up));
}

} // namespace vp::probe
