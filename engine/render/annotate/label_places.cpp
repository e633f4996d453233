#include "render/annotate/label_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <unordered_map>

namespace vp::render
{

namespace
{

// In heights of the label.
constexpr double kMargin = 0.35;  // free space on either side of a label, without lines or labels
constexpr double kMaxBend = 0.42; // largest distance of the line from the label's middle
constexpr double kProbe = 0.5;    // distance between the places where lines are looked for

// In lengths of the part that a label takes.
constexpr double kShortestLine = 1.6;
constexpr double kShortestLoop = 2.8;

// Penalties of a place. Less is better.
constexpr double kSteepness = 0.25; // penalty of an upright label
constexpr double kOffMiddle = 0.3;  // penalty of a label at an end of its line
constexpr double kOverLine = 1.5;   // penalty of each probe that meets another line
constexpr double kWorst = 3.0;      // at such a place there is no label

// A line by its length.
class Route
{
public:
	explicit Route(const LabeledLine& line) : points_(line.points)
	{
		if (line.closed && !points_.empty())
			points_.push_back(points_.front());
		lengths_.push_back(0.0);
		for (std::size_t i = 1; i < points_.size(); ++i)
			lengths_.push_back(lengths_.back() + glm::length(points_[i] - points_[i - 1]));
	}

	double length() const { return lengths_.back(); }

	glm::dvec2 at(double s) const
	{
		const std::size_t i = segment(s);
		const double part = lengths_[i + 1] - lengths_[i];
		return part > 0.0 ? glm::mix(points_[i], points_[i + 1], std::clamp((s - lengths_[i]) / part, 0.0, 1.0))
		                  : points_[i];
	}

	std::vector<glm::dvec2> between(double from, double to) const
	{
		std::vector<glm::dvec2> result{at(from)};
		for (std::size_t i = 0; i < points_.size(); ++i)
			if (lengths_[i] > from && lengths_[i] < to)
				result.push_back(points_[i]);
		result.push_back(at(to));
		return result;
	}

	// The lengths at which it may be in an area: visit(from, to) for each of its segments that meets it. A line that
	// comes near the eye is millions of times as long as a picture is wide.
	template <class Visit>
	void forPartsIn(const Area& area, Visit&& visit) const
	{
		for (std::size_t i = 0; i + 1 < points_.size(); ++i)
		{
			double from = 0.0;
			double to = 1.0;
			for (int axis = 0; axis < 2; ++axis)
			{
				const double a = points_[i][axis];
				const double way = points_[i + 1][axis] - a;
				const double enters = ((way < 0.0 ? area.hi : area.lo)[axis] - a) / way;
				const double leaves = ((way < 0.0 ? area.lo : area.hi)[axis] - a) / way;
				if (way == 0.0)
					to = a >= area.lo[axis] && a <= area.hi[axis] ? to : -1.0;
				else
				{
					from = std::max(from, enters);
					to = std::min(to, leaves);
				}
			}
			if (from <= to && std::isfinite(lengths_[i + 1]))
				visit(glm::mix(lengths_[i], lengths_[i + 1], from), glm::mix(lengths_[i], lengths_[i + 1], to));
		}
	}

private:
	std::size_t segment(double s) const
	{
		const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, s);
		return static_cast<std::size_t>(after - lengths_.begin()) - 1;
	}

	std::vector<glm::dvec2> points_;
	std::vector<double> lengths_;
};

struct Box2
{
	glm::dvec2 center;
	glm::dvec2 along; // unit
	glm::dvec2 half;  // along, across

	glm::dvec2 across() const { return {-along.y, along.x}; }
	glm::dvec2 inside(const glm::dvec2& p) const // in the box' own axes
	{
		return {glm::dot(p - center, along), glm::dot(p - center, across())};
	}
	bool holds(const glm::dvec2& p) const
	{
		const glm::dvec2 q = glm::abs(inside(p));
		return q.x <= half.x && q.y <= half.y;
	}
	double reach(const glm::dvec2& axis) const
	{
		return half.x * std::abs(glm::dot(along, axis)) + half.y * std::abs(glm::dot(across(), axis));
	}
	bool overlaps(const Box2& other) const
	{
		for (const glm::dvec2& axis : {along, across(), other.along, other.across()})
			if (std::abs(glm::dot(other.center - center, axis)) > reach(axis) + other.reach(axis))
				return false;
		return true;
	}
	bool within(const Area& area) const
	{
		const glm::dvec2 r(reach({1.0, 0.0}), reach({0.0, 1.0}));
		const glm::dvec2 lo = center - r;
		const glm::dvec2 hi = center + r;
		return lo.x >= area.lo.x && lo.y >= area.lo.y && hi.x <= area.hi.x && hi.y <= area.hi.y;
	}
};

// Where lines run within an area, in squares of a label's height.
class LineMap
{
public:
	LineMap(std::span<const Route> routes, double height, const Area& within) : cell_(height)
	{
		const double step = kProbe * height;
		for (std::size_t i = 0; i < routes.size(); ++i)
			routes[i].forPartsIn(within,
			                     [&](double from, double to)
			                     {
				                     for (double n = std::ceil(from / step); n * step < to; n += 1.0)
				                     {
					                     const glm::dvec2 p = routes[i].at(n * step);
					                     probes_[name(glm::ivec2(glm::floor(p / cell_)))].push_back({i, p});
				                     }
			                     });
	}

	int othersIn(const Box2& box, std::size_t line) const
	{
		const glm::dvec2 reach(box.reach({1.0, 0.0}), box.reach({0.0, 1.0}));
		const glm::ivec2 lo(glm::floor((box.center - reach) / cell_));
		const glm::ivec2 hi(glm::floor((box.center + reach) / cell_));
		int found = 0;
		for (int y = lo.y; y <= hi.y; ++y)
			for (int x = lo.x; x <= hi.x; ++x)
				if (const auto at = probes_.find(name({x, y})); at != probes_.end())
					for (const auto& [owner, p] : at->second)
						found += owner != line && box.holds(p);
		return found;
	}

private:
	static std::int64_t name(const glm::ivec2& cell) { return (std::int64_t(cell.y) << 32) ^ std::uint32_t(cell.x); }

	double cell_;
	std::unordered_map<std::int64_t, std::vector<std::pair<std::size_t, glm::dvec2>>> probes_;
};

struct Candidate
{
	LabelPlace place;
	Box2 box;
	double marks;
};

// The label's direction from the line's: to the right, of upright ones upwards.
glm::dvec2 readable(const glm::dvec2& direction)
{
	const bool upright = std::abs(direction.x) < 1e-6;
	return (upright ? direction.y > 0.0 : direction.x < 0.0) ? -direction : direction;
}

std::optional<Candidate> candidateAt(const Route& route, std::size_t line, double from, double taken, double width,
                                     double height)
{
	const glm::dvec2 a = route.at(from);
	const glm::dvec2 chord = route.at(from + taken) - a;
	const double length = glm::length(chord);
	if (length < 0.9 * taken)
		return std::nullopt;
	const glm::dvec2 along = readable(chord / length);
	const Box2 box{a + 0.5 * chord, along, {0.5 * width + kMargin * height, 0.5 * height}};
	constexpr int kSteps = 8;
	double bend = 0.0;
	for (int i = 1; i < kSteps; ++i)
		bend = std::max(bend, std::abs(box.inside(route.at(from + taken * i / kSteps)).y) / height);
	if (bend > kMaxBend)
		return std::nullopt;
	const double angle = std::atan2(along.y, along.x);
	const double marks = bend / kMaxBend + kSteepness * std::abs(angle) / (0.5 * std::numbers::pi);
	return Candidate{{line, box.center, angle, from, from + taken}, box, marks};
}

std::vector<Candidate> candidatesOf(const Route& route, std::size_t line, double width, bool closed, double height)
{
	std::vector<Candidate> result;
	const double taken = width + 2.0 * kMargin * height;
	if (!(width > 0.0) || route.length() < (closed ? kShortestLoop : kShortestLine) * taken)
		return result;
	const double step = std::max(0.25 * taken, (route.length() - taken) / 400.0);
	for (double from = 0.0; from + taken <= route.length(); from += step)
		if (auto candidate = candidateAt(route, line, from, taken, width, height))
		{
			candidate->marks += kOffMiddle * std::abs(2.0 * (from + 0.5 * taken) / route.length() - 1.0);
			result.push_back(*candidate);
		}
	return result;
}

} // namespace

std::vector<LabelPlace> placeLabels(std::span<const LabeledLine> lines, double height, double spacing,
                                    const Area& within, std::span<const Area> taken_areas,
                                    const std::function<bool(std::size_t, const glm::dvec2&)>& seen)
{
	std::vector<Route> routes;
	for (const LabeledLine& line : lines)
		routes.emplace_back(line);
	const LineMap map(routes, height, within);
	std::vector<std::size_t> order(lines.size());
	std::iota(order.begin(), order.end(), std::size_t(0));
	std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return routes[i].length(); });

	std::vector<LabelPlace> places;
	std::vector<Box2> taken;
	for (const Area& area : taken_areas)
		taken.push_back({0.5 * (area.lo + area.hi), {1.0, 0.0}, 0.5 * area.size()});
	for (const std::size_t line : order)
	{
		if (lines[line].points.size() < 2)
			continue;
		std::vector<Candidate> candidates =
		    candidatesOf(routes[line], line, lines[line].width, lines[line].closed, height);
		std::erase_if(candidates, [&](const Candidate& c) { return !c.box.within(within); });
		for (Candidate& candidate : candidates)
			candidate.marks += kOverLine * map.othersIn(candidate.box, line);
		std::ranges::stable_sort(candidates, {}, &Candidate::marks);
		const std::size_t first = places.size();
		for (const Candidate& c : candidates)
		{
			const auto near = [&](const LabelPlace& p) { return std::abs(p.from - c.place.from) < spacing; };
			Box2 wide = c.box;
			wide.half += kMargin * height;
			if (c.marks > kWorst || std::any_of(places.begin() + std::ptrdiff_t(first), places.end(), near) ||
			    std::ranges::any_of(taken, [&](const Box2& box) { return box.overlaps(wide); }) ||
			    (seen && !seen(line, c.place.center)))
				continue;
			places.push_back(c.place);
			taken.push_back(c.box);
		}
	}
	return places;
}

std::vector<std::vector<glm::dvec2>> withGaps(const LabeledLine& line, std::span<const LabelPlace> places)
{
	const Route route(line);
	std::vector<std::pair<double, double>> gaps;
	for (const LabelPlace& place : places)
		gaps.emplace_back(place.from, place.to);
	std::ranges::sort(gaps);
	std::vector<std::vector<glm::dvec2>> parts;
	double from = 0.0;
	for (const auto& [begin, end] : gaps)
	{
		if (begin > from)
			parts.push_back(route.between(from, begin));
		from = end;
	}
	if (from < route.length())
		parts.push_back(route.between(from, route.length()));
	return parts;
}

} // namespace vp::render
