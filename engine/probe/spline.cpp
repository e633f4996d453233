#include "probe/spline.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vp::probe
{

namespace
{

using Quaternion = glm::dquat;

Quaternion orientationOf(const Frame& frame)
{
	return glm::normalize(glm::quat_cast(glm::dmat3(frame.xAxis(), frame.up, frame.normal)));
}

// The rotation about v by |v| radians.
Quaternion turnBy(const Vec3& v)
{
	const double half = 0.5 * glm::length(v);
	const double sinc = half < 1e-8 ? 1.0 : std::sin(half) / half;
	return {std::cos(half), 0.5 * sinc * v.x, 0.5 * sinc * v.y, 0.5 * sinc * v.z};
}

// The inverse of turnBy. Returns the shorter way round.
Vec3 rotationVector(const Quaternion& q)
{
	const Vec3 axis(q.x, q.y, q.z);
	const double sine = glm::length(axis);
	const double sign = q.w < 0.0 ? -1.0 : 1.0;
	if (sine < 1e-12)
		return 2.0 * sign * axis;
	return 2.0 * sign * std::atan2(sine, sign * q.w) / sine * axis;
}

// A key and what happens between it and the next, or the key before and it.
struct Motion
{
	Vec3 shift;    // per unit of time
	Vec3 turn;     // likewise, in the coordinates of either end: a constant turn leaves its axis alone
	double length; // in time

	bool isRest() const { return shift == Vec3(0.0) && turn == Vec3(0.0); }
};

class Spline
{
public:
	Spline(std::span<const Key> keys, double period) : keys_(keys), period_(period) {}

	// Between key i and the one after it, at 0 <= t <= 1.
	Frame pose(std::ptrdiff_t i, double t) const
	{
		const Motion motion = motionAfter(i);
		const Motion start = velocityAt(i);
		const Motion end = velocityAt(i + 1);
		if (motion.isRest() && start.isRest() && end.isRest())
			return key(i).frame; // to the last bit: what rests is not cut again
		const double h = motion.length;
		const double rest = 1.0 - t;
		// The cumulative Bernstein polynomials of degree 3.
		const double b1 = 1.0 - rest * rest * rest;
		const double b2 = t * t * (3.0 - 2.0 * t);
		const double b3 = t * t * t;

		const Vec3 leave = h / 3.0 * start.shift;
		const Vec3 arrive = h / 3.0 * end.shift;
		const Vec3 between = h * motion.shift - leave - arrive;
		const Vec3 origin = key(i).frame.origin + b1 * leave + b2 * between + b3 * arrive;

		const Quaternion from = orientationOf(key(i).frame);
		const Quaternion turn_leave = turnBy(h / 3.0 * start.turn);
		const Quaternion turn_arrive = turnBy(h / 3.0 * end.turn);
		const Quaternion whole = turnBy(h * motion.turn);
		const Vec3 turn_between = rotationVector(glm::conjugate(turn_leave) * whole * glm::conjugate(turn_arrive));
		const Quaternion q =
		    from * turnBy(b1 * h / 3.0 * start.turn) * turnBy(b2 * turn_between) * turnBy(b3 * h / 3.0 * end.turn);
		return makeFrame(origin, q * Vec3(0.0, 0.0, 1.0), q * Vec3(0.0, 1.0, 0.0));
	}

private:
	std::ptrdiff_t size() const { return std::ssize(keys_); }
	const Key& key(std::ptrdiff_t i) const { return keys_[static_cast<std::size_t>((i + size()) % size())]; }

	Motion motionAfter(std::ptrdiff_t i) const
	{
		const Key& a = key(i);
		const Key& b = key(i + 1);
		const double length = b.at > a.at ? b.at - a.at : b.at - a.at + period_;
		const Quaternion turn = glm::conjugate(orientationOf(a.frame)) * orientationOf(b.frame);
		return {(b.frame.origin - a.frame.origin) / length, rotationVector(turn) / length, length};
	}

	// Returns the motion of the parabola through a key and its neighbors, at the key.
	static Motion middle(const Motion& before, const Motion& after)
	{
		const double share = before.length / (before.length + after.length);
		return {glm::mix(before.shift, after.shift, share), glm::mix(before.turn, after.turn, share), 0.0};
	}
	// Returns the motion of the parabola at its end beyond `next`.
	static Motion atEnd(const Motion& motion, const Motion& next)
	{
		return {2.0 * motion.shift - next.shift, 2.0 * motion.turn - next.turn, 0.0};
	}

	Motion velocityAt(std::ptrdiff_t i) const
	{
		const std::ptrdiff_t last = size() - 1;
		if (period_ > 0.0 || (i > 0 && i < last))
			return middle(motionAfter(i - 1), motionAfter(i));
		if (last == 1)
			return motionAfter(0);
		if (i == 0)
			return atEnd(motionAfter(0), velocityAt(1));
		return atEnd(motionAfter(last - 1), velocityAt(last - 1));
	}

	std::span<const Key> keys_;
	double period_;
};

} // namespace

Frame splinePose(std::span<const Key> keys, double period, double time)
{
	assert(keys.size() >= 2);
	const double start = keys.front().at;
	const double end = period > 0.0 ? start + period : keys.back().at;
	if (period > 0.0)
		time = start + std::fmod(time - start, period);
	// A frame at a key is the key's, though its time was computed in another way.
	const double same = 1e-12 * (std::abs(start) + std::abs(end));
	const auto after = std::ranges::upper_bound(keys, time + same, {}, &Key::at);
	if (after == keys.begin())
		return keys.front().frame;
	const Key& before = *(after - 1);
	if (time <= before.at + same || (after == keys.end() && !(period > 0.0)))
		return before.frame;
	const double next = after == keys.end() ? end : after->at;
	return Spline(keys, period).pose(after - keys.begin() - 1, (time - before.at) / (next - before.at));
}

} // namespace vp::probe
