#include "mesh/polygon_fans.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace vp::mesh
{

namespace
{

using glm::dvec2;

// Twice the area of a triangle, positive when it runs counter-clockwise, and what of it may be rounding.
struct Turn
{
	dvec2 ab;
	dvec2 ac;
	double area;

	Turn(const dvec2& a, const dvec2& b, const dvec2& c) : ab(b - a), ac(c - a), area(ab.x * ac.y - ab.y * ac.x) {}
	// Slack is asked for last: most turns are clear without it.
	bool clockwise() const { return area < 0.0 && area < -slack(); }
	bool counterClockwise() const { return area > 0.0 && area > slack(); }

private:
	double slack() const
	{
		constexpr double kStraight = 1e-9;
		return kStraight * glm::length(ab) * glm::length(ac);
	}
};

class EarClipper
{
public:
	explicit EarClipper(std::span<const dvec2> polygon) : places_(polygon), left_(polygon.size())
	{
		std::iota(left_.begin(), left_.end(), 0u);
	}

	std::vector<std::vector<std::uint32_t>> fans()
	{
		while (left_.size() >= 3)
			if (!clipSomewhere())
			{
				fans_.push_back(left_);
				break;
			}
		return std::move(fans_);
	}

private:
	// Clips the ears about the first corner that has any, or a spike.
	bool clipSomewhere()
	{
		for (std::size_t n = 0; n < left_.size(); ++n)
		{
			if (isSpike(1))
			{
				left_.erase(left_.begin() + 1);
				return true;
			}
			std::vector<std::uint32_t> fan{left_[0], left_[1]};
			// An ear that a spike begins would reach over its line.
			while (left_.size() >= 3 && !isSpike(2) && isEar())
			{
				fan.push_back(left_[2]);
				left_.erase(left_.begin() + 1);
			}
			if (fan.size() > 2)
			{
				fans_.push_back(std::move(fan));
				return true;
			}
			std::rotate(left_.begin(), left_.begin() + 1, left_.end());
		}
		return false;
	}

	// Returns true if this one of the remaining corners has no width. That is the rest of a bridge of which one side is
	// clipped off.
	bool isSpike(std::size_t corner) const
	{
		const dvec2& a = places_[left_[corner - 1]];
		const dvec2& b = places_[left_[corner]];
		const dvec2& c = places_[left_[(corner + 1) % left_.size()]];
		const Turn turn(b, c, a);
		return a == b || (!turn.clockwise() && !turn.counterClockwise() && glm::dot(a - b, c - b) > 0.0);
	}

	// Returns true if the first three remaining corners make a triangle within the rest of the polygon.
	bool isEar() const
	{
		const std::array<dvec2, 3> triangle{places_[left_[0]], places_[left_[1]], places_[left_[2]]};
		if (!Turn(triangle[0], triangle[1], triangle[2]).counterClockwise())
			return false;
		for (std::size_t i = 3; i < left_.size(); ++i)
		{
			const auto at = std::ranges::find(triangle, places_[left_[i]]);
			if (at == triangle.end() ? holds(triangle, places_[left_[i]])
			                         : leadsInto(triangle, at - triangle.begin(), i))
				return false;
		}
		return true;
	}

	static bool holds(const std::array<dvec2, 3>& t, const dvec2& p)
	{
		return !Turn(t[0], t[1], p).clockwise() && !Turn(t[1], t[2], p).clockwise() && !Turn(t[2], t[0], p).clockwise();
	}

	// Returns true if the polygon runs into the triangle where its corner `i` meets corner `at` of the triangle again.
	// That happens because clipping leaves bridges without width.
	bool leadsInto(const std::array<dvec2, 3>& t, std::ptrdiff_t at, std::size_t i) const
	{
		const auto within = [&](const dvec2& p) {
			return Turn(t[at], t[(at + 1) % 3], p).counterClockwise() &&
			       Turn(t[at], p, t[(at + 2) % 3]).counterClockwise();
		};
		return within(places_[left_[i - 1]]) || within(places_[left_[(i + 1) % left_.size()]]);
	}

	std::span<const dvec2> places_;
	std::vector<std::uint32_t> left_; // corners, in order
	std::vector<std::vector<std::uint32_t>> fans_;
};

} // namespace

bool isFan(std::span<const dvec2> polygon)
{
	for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
		if (Turn(polygon[0], polygon[i], polygon[i + 1]).clockwise())
			return false;
	return true;
}

std::vector<std::vector<std::uint32_t>> cutIntoFans(std::span<const dvec2> polygon)
{
	std::vector<std::uint32_t> corners(polygon.size());
	std::iota(corners.begin(), corners.end(), 0u);
	if (polygon.size() > kMaxEarCorners)
		return {corners};
	std::vector<dvec2> turned(polygon.begin(), polygon.end());
	for (std::size_t n = 0; n < polygon.size(); ++n)
	{
		if (isFan(turned))
			return {corners};
		std::rotate(turned.begin(), turned.begin() + 1, turned.end());
		std::rotate(corners.begin(), corners.begin() + 1, corners.end());
	}
	// Corners that rounding holds apart, as where a hole touches the rim, have no turn that means anything.
	constexpr double kOnePlace = 1e-12;
	dvec2 lo = turned[0];
	dvec2 hi = turned[0];
	for (const dvec2& p : turned)
	{
		lo = glm::min(lo, p);
		hi = glm::max(hi, p);
	}
	turned.assign(polygon.begin(), polygon.end());
	for (std::size_t i = 1; i < turned.size(); ++i)
		for (std::size_t j = 0; j < i; ++j)
			if (glm::distance(turned[i], turned[j]) <= kOnePlace * glm::distance(lo, hi))
				turned[i] = turned[j];
	return EarClipper(turned).fans();
}

} // namespace vp::mesh
