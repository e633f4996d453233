#include "mesh/nearest_point_cells.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vp::mesh
{

namespace
{

constexpr double kRounding = 1e-10; // a share of the polygon's size

bool isSameLabel(double a, double b)
{
	return a == b || (std::isnan(a) && std::isnan(b));
}

} // namespace

int NearestPointCells::sharedSide(const Corner& a, const Corner& b)
{
	for (const int side : a.sides)
		if (side >= 0 && (side == b.sides[0] || side == b.sides[1]))
			return side;
	return -1;
}

Vec3 NearestPointCells::doubleArea(const Loop& loop) const
{
	Vec3 sum(0.0);
	for (std::size_t i = 1; i + 1 < loop.size(); ++i)
		sum += glm::cross(corners_[loop[i]].place - corners_[loop[0]].place,
		                  corners_[loop[i + 1]].place - corners_[loop[0]].place);
	return sum;
}

// Places that the same cuts give again are one corner.
std::uint32_t NearestPointCells::cornerBetween(std::uint32_t a, std::uint32_t b, double part)
{
	const Vec3 place = corners_[a].place + part * (corners_[b].place - corners_[a].place);
	const int side = sharedSide(corners_[a], corners_[b]);
	for (std::uint32_t known = 0; known < corners_.size(); ++known)
		if (const Vec3 way = corners_[known].place - place; glm::dot(way, way) <= tolerance_ * tolerance_)
		{
			int(&sides)[2] = corners_[known].sides;
			if (side >= 0 && sides[0] != side && sides[1] < 0)
				sides[sides[0] < 0 ? 0 : 1] = side;
			return known;
		}
	corners_.push_back({place, -1, {side, -1}});
	return static_cast<std::uint32_t>(corners_.size() - 1);
}

// Keeps what lies nearer to one point than to another. Returns false if that is nothing. Sutherland and Hodgman's.
bool NearestPointCells::clip(Loop& loop, const ValuedPoint& kept, const ValuedPoint& other, bool prefers_kept)
{
	const Vec3 way = other.place - kept.place;
	const double length = glm::length(way);
	if (!(length > tolerance_)) // one place
		return prefers_kept;
	along_.clear();
	double least = 0.0;
	double most = 0.0;
	for (const std::uint32_t c : loop)
	{
		const double beyond = glm::dot(corners_[c].place - 0.5 * (kept.place + other.place), way) / length;
		along_.push_back(std::abs(beyond) <= tolerance_ ? 0.0 : beyond);
		least = std::min(least, along_.back());
		most = std::max(most, along_.back());
	}
	if (least == 0.0 && most == 0.0)
		return prefers_kept;
	if (least == 0.0)
		return false;
	if (most == 0.0)
		return true;
	clipped_.clear();
	for (std::size_t i = 0; i < loop.size(); ++i)
	{
		const std::size_t next = i + 1 < loop.size() ? i + 1 : 0;
		if (along_[i] <= 0.0)
			clipped_.push_back(loop[i]);
		if (along_[i] * along_[next] < 0.0)
		{
			// From the lower end, so that the place is the same from both sides.
			const bool rises = loop[i] < loop[next];
			const std::size_t from = rises ? i : next;
			const std::size_t to = rises ? next : i;
			clipped_.push_back(cornerBetween(loop[from], loop[to], along_[from] / (along_[from] - along_[to])));
		}
	}
	clipped_.erase(std::unique(clipped_.begin(), clipped_.end()), clipped_.end());
	while (clipped_.size() > 1 && clipped_.front() == clipped_.back())
		clipped_.pop_back();
	loop = clipped_;
	return loop.size() > 2;
}

void NearestPointCells::addRegion(const Loop& whole, std::span<const ValuedPoint> points, std::size_t nearest)
{
	Loop loop = whole;
	const ValuedPoint& kept = points[nearest];
	for (std::size_t p = 0; p < points.size(); ++p)
	{
		const bool prefers_kept =
		    isSameLabel(kept.value, points[p].value) ? nearest < p : !(points[p].value < kept.value);
		if (p != nearest && !clip(loop, kept, points[p], prefers_kept))
			return;
	}
	if (glm::length(doubleArea(loop)) > least_area_)
		parts_.push_back({std::move(loop), kept.value});
}

void NearestPointCells::part(std::span<const Vec3> polygon, std::span<const ValuedPoint> points)
{
	corners_.clear();
	parts_.clear();
	const int count = static_cast<int>(polygon.size());
	Loop whole;
	double size = 0.0;
	Vec3 mean(0.0);
	for (int i = 0; i < count; ++i)
	{
		corners_.push_back({polygon[i], i, {i, i > 0 ? i - 1 : count - 1}});
		whole.push_back(static_cast<std::uint32_t>(i));
		size = std::max(size, glm::length(polygon[i] - polygon[0]));
		mean += polygon[i] / static_cast<double>(count);
	}
	tolerance_ = kRounding * size;
	const Vec3 area = doubleArea(whole);
	least_area_ = kRounding * glm::length(area);
	bool is_convex = true;
	for (int i = 0; i < count; ++i)
	{
		const Vec3& corner = polygon[(i + 1) % count];
		const Vec3 turn = glm::cross(corner - polygon[i], polygon[(i + 2) % count] - corner);
		is_convex = is_convex && glm::dot(turn, area) >= -least_area_ * glm::length(area);
	}
	if (is_convex)
		for (std::size_t p = 0; p < points.size(); ++p)
			addRegion(whole, points, p);
	else
	{
		const auto center = static_cast<std::uint32_t>(corners_.size());
		corners_.push_back({mean, -1, {-1, -1}});
		for (std::uint32_t i = 0; i < whole.size(); ++i)
		{
			const Loop triangle{i, static_cast<std::uint32_t>((i + 1) % whole.size()), center};
			for (std::size_t p = 0; p < points.size() && glm::dot(doubleArea(triangle), area) > 0.0; ++p)
				addRegion(triangle, points, p);
		}
	}
	join();
}

// On a side of the polygon, joined parts have corners where only they met; the polygon across the side has none there.
void NearestPointCells::dropNeedlessCorners(Loop& loop) const
{
	Loop kept;
	for (std::size_t i = 0; i < loop.size(); ++i)
	{
		const Corner& at = corners_[loop[i]];
		const int before = sharedSide(corners_[loop[(i + loop.size() - 1) % loop.size()]], at);
		const int after = sharedSide(at, corners_[loop[(i + 1) % loop.size()]]);
		if (at.vertex >= 0 || before < 0 || before != after)
			kept.push_back(loop[i]);
	}
	loop = std::move(kept);
}

// Joins parts of one value: sides that two of them have in opposite senses go, and the others are linked. If that gives
// no simple polygons, as around a part of another value, the parts stay as they are.
void NearestPointCells::join()
{
	std::stable_sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.value < b.value; });
	std::vector<Part> joined;
	for (std::size_t first = 0, last = 0; first < parts_.size(); first = last)
	{
		while (last < parts_.size() && isSameLabel(parts_[last].value, parts_[first].value))
			++last;
		std::map<std::uint32_t, std::uint32_t> next; // corner after a corner
		bool is_simple = true;
		std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
		Vec3 area(0.0);
		for (std::size_t p = first; p < last; ++p)
		{
			area += doubleArea(parts_[p].corners);
			for (std::size_t i = 0; i < parts_[p].corners.size(); ++i)
				sides.emplace_back(parts_[p].corners[i], parts_[p].corners[(i + 1) % parts_[p].corners.size()]);
		}
		for (const auto& [from, to] : sides)
			if (std::ranges::find(sides, std::pair{to, from}) == sides.end())
				is_simple = next.emplace(from, to).second && is_simple;
		std::vector<Part> loops;
		while (is_simple && !next.empty())
		{
			Part& loop = loops.emplace_back(Part{{}, parts_[first].value});
			std::uint32_t at = next.begin()->first;
			for (auto step = next.find(at); step != next.end(); step = next.find(at))
			{
				loop.corners.push_back(at);
				at = step->second;
				next.erase(step);
			}
			is_simple =
			    at == loop.corners.front() && loop.corners.size() > 2 && glm::dot(doubleArea(loop.corners), area) > 0.0;
		}
		for (Part& loop : loops)
			dropNeedlessCorners(loop.corners);
		if (last - first > 1 && is_simple)
			std::ranges::move(loops, std::back_inserter(joined));
		else
			std::move(parts_.begin() + static_cast<std::ptrdiff_t>(first),
			          parts_.begin() + static_cast<std::ptrdiff_t>(last), std::back_inserter(joined));
	}
	parts_ = std::move(joined);
}

} // namespace vp::mesh
