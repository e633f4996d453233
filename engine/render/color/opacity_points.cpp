#include "render/color/opacity_points.h"

#include "render/color/preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::render
{

namespace
{

// A table of colors rounds opacities to 1/255, so that points of a straight line depart from it by half of that.
constexpr double kRounding = 0.51 / 255.0;

// The points as a preset has them: straight lines between them.
std::vector<double> presetPoints(const OpacityPoints& points)
{
	std::vector<double> numbers;
	for (const OpacityPoint& point : points)
		numbers.insert(numbers.end(), {point.place, point.opacity, 0.5, 0.0});
	return numbers;
}

OpacityPoint colorAsPoint(const ColorMap& map, int color)
{
	return {double(color) / (kColorMapSize - 1), map.colors[color].a / 255.0};
}

// Adds the color between two that departs the most from the line between them, and those on either side of it (Douglas
// and Peucker, 1973).
void keepCorners(const ColorMap& map, int first, int last, double tolerance, OpacityPoints& kept)
{
	const OpacityPoints line{colorAsPoint(map, first), colorAsPoint(map, last)};
	int farthest = first;
	double most = tolerance;
	for (int i = first + 1; i < last; ++i)
	{
		const OpacityPoint seen = colorAsPoint(map, i);
		if (const double off = std::abs(seen.opacity - opacityAt(line, seen.place)); off > most)
		{
			most = off;
			farthest = i;
		}
	}
	if (farthest == first)
		return;
	keepCorners(map, first, farthest, tolerance, kept);
	kept.push_back(colorAsPoint(map, farthest));
	keepCorners(map, farthest, last, tolerance, kept);
}

} // namespace

std::vector<double> opacityNumbers(const OpacityPoints& points)
{
	std::vector<double> numbers;
	for (const OpacityPoint& point : points)
		numbers.insert(numbers.end(), {point.place, point.opacity});
	return numbers;
}

OpacityPoints opacityPoints(std::span<const double> numbers)
{
	OpacityPoints points;
	for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
		points.push_back({numbers[i], numbers[i + 1]});
	return points;
}

std::string whyNoOpacityPoints(std::span<const double> numbers)
{
	if (numbers.empty())
		return {};
	if (numbers.size() % 2 != 0 || numbers.size() < 4 || numbers.size() > 2 * kMaxOpacityPoints)
		return fmt::format("{} numbers are no points; give a place and an opacity for each of 2 to {} points",
		                   numbers.size(), kMaxOpacityPoints);
	for (std::size_t i = 2; i < numbers.size(); i += 2)
		if (numbers[i] < numbers[i - 2])
			return fmt::format("the place {} is behind {}; give the points in ascending order", numbers[i - 2],
			                   numbers[i]);
	return {};
}

ColorMap withOpacity(ColorMap map, const OpacityPoints& points)
{
	if (points.empty() || !map.categories.empty())
		return map;
	const std::vector<double> numbers = presetPoints(points);
	for (int i = 0; i < kColorMapSize; ++i)
		map.colors[i].a = colorOf({}, presetOpacity(numbers, double(i) / (kColorMapSize - 1))).a;
	return map;
}

OpacityPoints opacityPointsOf(const ColorMap& map)
{
	constexpr int kLast = kColorMapSize - 1;
	for (double tolerance = kRounding;; tolerance *= 2.0)
	{
		OpacityPoints points{colorAsPoint(map, 0)};
		keepCorners(map, 0, kLast, tolerance, points);
		points.push_back(colorAsPoint(map, kLast));
		if (points.size() <= kMaxOpacityPoints)
			return points;
	}
}

double opacityAt(const OpacityPoints& points, double place)
{
	return presetOpacity(presetPoints(points), place);
}

std::size_t addPoint(OpacityPoints& points, const OpacityPoint& added)
{
	const auto behind = std::find_if(points.begin(), points.end(),
	                                 [&](const OpacityPoint& point) { return point.place > added.place; });
	const auto number = static_cast<std::size_t>(behind - points.begin());
	if (points.size() >= kMaxOpacityPoints)
		return std::min(number, points.size() - 1);
	points.insert(behind, {std::clamp(added.place, 0.0, 1.0), std::clamp(added.opacity, 0.0, 1.0)});
	return number;
}

std::size_t addBeside(OpacityPoints& points, std::size_t point)
{
	const std::size_t first = std::min(point, points.size() - 2);
	const OpacityPoint& a = points[first];
	const OpacityPoint& b = points[first + 1];
	return addPoint(points, {0.5 * (a.place + b.place), 0.5 * (a.opacity + b.opacity)});
}

std::size_t movePoint(OpacityPoints& points, std::size_t point, const OpacityPoint& to)
{
	const double lo = point > 0 ? points[point - 1].place : 0.0;
	const double hi = point + 1 < points.size() ? points[point + 1].place : 1.0;
	points[point] = {std::clamp(to.place, lo, hi), std::clamp(to.opacity, 0.0, 1.0)};
	return point;
}

std::size_t removePoint(OpacityPoints& points, std::size_t point)
{
	if (points.size() > 2)
		points.erase(points.begin() + static_cast<std::ptrdiff_t>(point));
	return std::min(point, points.size() - 1);
}

} // namespace vp::render
