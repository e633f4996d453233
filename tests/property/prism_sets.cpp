#include "prism_sets.h"

#include "test_grids.h"

#include "base/cross2.h"

#include <algorithm>
#include <utility>

namespace vp::test
{

namespace
{

using glm::dvec2;

double turnOf(const dvec2& a, const dvec2& b, const dvec2& c)
{
	return cross(b - a, c - a);
}

bool sidesCross(const dvec2& a, const dvec2& b, const dvec2& c, const dvec2& d)
{
	return turnOf(a, b, c) * turnOf(a, b, d) < 0.0 && turnOf(c, d, a) * turnOf(c, d, b) < 0.0;
}

// Random points in an order in which no two sides cross: crossing ones are turned round, which makes the way shorter.
std::vector<dvec2> simplePolygon(Draw& draw)
{
	std::vector<dvec2> polygon;
	const int corners = draw.whole(4, 14);
	for (int i = 0; i < corners; ++i)
	{
		const double x = draw.real(0.1, 0.9);
		polygon.emplace_back(x, draw.real(0.1, 0.9));
	}
	const std::size_t n = polygon.size();
	for (bool changed = true; changed;)
	{
		changed = false;
		for (std::size_t i = 0; i < n; ++i)
			for (std::size_t j = i + 2; j < n; ++j)
				if (sidesCross(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n]))
				{
					std::reverse(polygon.begin() + static_cast<std::ptrdiff_t>(i) + 1,
					             polygon.begin() + static_cast<std::ptrdiff_t>(j) + 1);
					changed = true;
				}
	}
	double area = 0.0;
	for (std::size_t i = 0; i < n; ++i)
		area += cross(polygon[i], polygon[(i + 1) % n]);
	if (area < 0.0)
		std::ranges::reverse(polygon);
	return polygon;
}

// The points of a base and, behind them, of the top over it.
class Prisms
{
public:
	explicit Prisms(const PrismSet& set) : set_(set) {}

	std::int64_t point(const dvec2& p)
	{
		const auto known = std::ranges::find(base_, p);
		if (known == base_.end())
			base_.push_back(p);
		return std::ranges::find(base_, p) - base_.begin();
	}
	std::vector<Vec3> points() const
	{
		std::vector<Vec3> all;
		for (const double z : {0.0, set_.height})
			for (const dvec2& p : base_)
				all.push_back(set_.placed(Vec3(p, z)));
		return all;
	}
	// Faces over the base's lines, once all its points are known.
	std::vector<std::int64_t> side(const std::vector<std::int64_t>& line) const
	{
		std::vector<std::int64_t> face = line;
		for (auto p = line.rbegin(); p != line.rend(); ++p)
			face.push_back(*p + static_cast<std::int64_t>(base_.size()));
		return face;
	}
	std::vector<std::int64_t> top(std::vector<std::int64_t> bottom) const
	{
		for (std::int64_t& p : bottom)
			p += static_cast<std::int64_t>(base_.size());
		return bottom;
	}

private:
	const PrismSet& set_;
	std::vector<dvec2> base_;
};

struct ConvexPart
{
	std::vector<Vec3> corners;

	// Keeps what lies where normal . p >= least.
	void clip(const Vec3& normal, double least)
	{
		std::vector<Vec3> kept;
		for (std::size_t i = 0; i < corners.size(); ++i)
		{
			const Vec3& a = corners[i];
			const Vec3& b = corners[(i + 1) % corners.size()];
			const double da = glm::dot(normal, a) - least;
			const double db = glm::dot(normal, b) - least;
			if (da >= 0.0)
				kept.push_back(a);
			if ((da >= 0.0) != (db >= 0.0))
				kept.push_back(a + da / (da - db) * (b - a));
		}
		corners = std::move(kept);
	}
};

// In the set's own axes, by which neither lengths nor angles change.
class Sections
{
public:
	Sections(const PrismSet& set, const TestPlane& plane) : set_(set), origin_(own(plane.origin - set.shift))
	{
		const Vec3 normal = glm::normalize(own(plane.normal));
		x_ = glm::normalize(glm::cross(std::abs(normal.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0), normal));
		y_ = glm::cross(normal, x_);
	}

	// A convex base, counter-clockwise.
	void add(std::span<const dvec2> base, double sign)
	{
		constexpr double kFar = 20.0;
		ConvexPart part;
		for (const auto& [x, y] : {std::pair(-kFar, -kFar), {kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}})
			part.corners.push_back(origin_ + x * x_ + y * y_);
		part.clip({0, 0, 1}, 0.0);
		part.clip({0, 0, -1}, -set_.height);
		for (std::size_t i = 0; i < base.size(); ++i)
		{
			const dvec2 way = base[(i + 1) % base.size()] - base[i];
			const Vec3 normal(-way.y, way.x, 0.0);
			part.clip(normal, glm::dot(normal, Vec3(base[i], 0.0)));
		}
		for (std::size_t i = 1; i + 1 < part.corners.size(); ++i)
		{
			const Vec3& a = part.corners[0];
			const Vec3& b = part.corners[i];
			const Vec3& c = part.corners[i + 1];
			const double area = sign * 0.5 * glm::length(glm::cross(b - a, c - a));
			sum.area += area;
			sum.moment += area * linearAt(set_.placed((a + b + c) / 3.0));
		}
	}

	PrismSection sum;

private:
	Vec3 own(const Vec3& v) const
	{
		return {glm::dot(v, set_.axes[0]), glm::dot(v, set_.axes[1]), glm::dot(v, set_.axes[2])};
	}

	const PrismSet& set_;
	Vec3 origin_;
	Vec3 x_;
	Vec3 y_;
};

} // namespace

PrismSet prismSet(unsigned seed)
{
	Draw draw(seed);
	PrismSet set{
	    {}, simplePolygon(draw), draw.real(0.2, 1.0), {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, Vec3(0.0)};
	if (draw.chance(0.7))
	{
		set.axes[0] = draw.direction();
		set.axes[1] = glm::normalize(glm::cross(set.axes[0], draw.direction()));
		set.axes[2] = glm::cross(set.axes[0], set.axes[1]);
		set.shift = draw.around(3.0);
	}

	// Begins with the corner farthest to the left. Lines from there and from the one farthest to the right to the box's
	// sides part the rest of the base into a lower and an upper face.
	const auto byX = [](const dvec2& p) { return p.x; };
	std::rotate(set.polygon.begin(), std::ranges::min_element(set.polygon, {}, byX), set.polygon.end());
	Prisms prisms(set);
	std::vector<std::int64_t> polygon;
	for (const dvec2& p : set.polygon)
		polygon.push_back(prisms.point(p));
	const auto right = std::ranges::max_element(set.polygon, {}, byX) - set.polygon.begin();
	const std::int64_t left_side = prisms.point({0.0, set.polygon[0].y});
	const std::int64_t right_side = prisms.point({1.0, set.polygon[right].y});
	std::array<std::int64_t, 4> corners{};
	for (int i = 0; i < 4; ++i)
		corners[i] = prisms.point({i == 1 || i == 2 ? 1.0 : 0.0, i >= 2 ? 1.0 : 0.0});
	std::vector<std::int64_t> lower{left_side, corners[0], corners[1], right_side};
	for (std::ptrdiff_t i = right; i >= 0; --i)
		lower.push_back(polygon[i]);
	std::vector<std::int64_t> upper{right_side, corners[2], corners[3], left_side, polygon[0]};
	for (auto i = static_cast<std::ptrdiff_t>(polygon.size()) - 1; i >= right; --i)
		upper.push_back(polygon[i]);

	std::vector<std::vector<std::int64_t>> prism{polygon, prisms.top(polygon)};
	std::vector<std::vector<std::int64_t>> rest{lower,
	                                            upper,
	                                            prisms.top(lower),
	                                            prisms.top(upper),
	                                            prisms.side({corners[0], corners[1]}),
	                                            prisms.side({corners[1], right_side, corners[2]}),
	                                            prisms.side({corners[2], corners[3]}),
	                                            prisms.side({corners[3], left_side, corners[0]})};
	for (std::size_t i = 0; i < polygon.size(); ++i)
	{
		prism.push_back(prisms.side({polygon[i], polygon[(i + 1) % polygon.size()]}));
		rest.push_back(prism.back());
	}
	RawBlock block;
	block.points = prisms.points();
	for (auto* cell : {&prism, &rest})
	{
		for (std::vector<std::int64_t>& face : *cell)
		{
			std::rotate(face.begin(), face.begin() + draw.whole(0, static_cast<int>(face.size()) - 1), face.end());
			if (draw.chance(0.5))
				std::ranges::reverse(face);
		}
		block.cells.push_back({42, {}, std::move(*cell)});
	}
	std::mt19937 random(seed);
	std::vector<std::size_t> order;
	RawBlock mixed = shuffled(block, random, order);
	if (order[0] != 0)
		std::swap(mixed.cells[0], mixed.cells[1]);
	set.raw.name = "prism";
	set.raw.flat_faces = true;
	set.raw.blocks.push_back(std::move(mixed));
	return set;
}

TestPlane prismPlane(const PrismSet& set, unsigned seed)
{
	Draw draw(seed);
	const auto inside = [&] { return set.placed(Vec3(0.5, 0.5, 0.5 * set.height) + draw.around(0.25)); };
	const auto corner = [&](std::size_t i, double z) { return set.placed(Vec3(set.polygon[i], z)); };
	const std::size_t i = static_cast<std::size_t>(draw.whole(0, static_cast<int>(set.polygon.size()) - 3));
	switch (seed % 4)
	{
	case 0: // across the axis
		return {set.placed({0.5, 0.5, draw.real(0.1, 0.9) * set.height}), set.axes[2]};
	case 1: // along the axis
		return {inside(), glm::cross(set.axes[2], draw.direction())};
	case 2: // through two corners, not of one side
		return {corner(i, 0.0), glm::cross(corner(i + 2, set.height) - corner(i, 0.0), draw.direction())};
	default:
		return {inside(), draw.direction()};
	}
}

PrismSection sectionOfPrism(const PrismSet& set, const TestPlane& plane)
{
	Sections sections(set, plane);
	for (std::size_t i = 0; i < set.polygon.size(); ++i)
	{
		const dvec2& a = set.polygon[i];
		const dvec2& b = set.polygon[(i + 1) % set.polygon.size()];
		if (cross(a, b) > 0.0)
			sections.add(std::array{dvec2(0.0), a, b}, 1.0);
		else if (cross(a, b) < 0.0)
			sections.add(std::array{dvec2(0.0), b, a}, -1.0);
	}
	return sections.sum;
}

PrismSection sectionOfBox(const PrismSet& set, const TestPlane& plane)
{
	Sections sections(set, plane);
	sections.add(std::array{dvec2(0, 0), dvec2(1, 0), dvec2(1, 1), dvec2(0, 1)}, 1.0);
	return sections.sum;
}

} // namespace vp::test
