#pragma once

#include "render/color/color_map.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace vp::render
{

/// A point of an opacity by value: a place between the ends of the colors, and the opacity there. Both are from 0 to 1.
struct OpacityPoint
{
	double place = 0.0;
	double opacity = 1.0;

	bool operator==(const OpacityPoint&) const = default;
};

/// Two or more points with ascending places. The opacity is linear between two of them, and constant before the first
/// and behind the last.
using OpacityPoints = std::vector<OpacityPoint>;

constexpr std::size_t kMaxOpacityPoints = 32;

// Settings hold points as pairs of numbers.
std::vector<double> opacityNumbers(const OpacityPoints& points);
/// Returns no points if the numbers are none.
OpacityPoints opacityPoints(std::span<const double> numbers);
/// Returns why numbers from 0 to 1 are no points; empty if they are, or if there are none.
std::string whyNoOpacityPoints(std::span<const double> numbers);

/// Replaces the opacities of the map's colors. Without points, and for categories, the map stays as it is.
ColorMap withOpacity(ColorMap map, const OpacityPoints& points);

/// Returns few points, at most kMaxOpacityPoints, that give the opacities of the map's colors to about 1/255.
OpacityPoints opacityPointsOf(const ColorMap& map);

double opacityAt(const OpacityPoints& points, double place);

// Editing. Each function returns the number of the point that the user goes on with.

/// Adds a point. Returns an existing point if there is no room for more.
std::size_t addPoint(OpacityPoints& points, const OpacityPoint& added);
/// Adds a point half way from one to the next, or from the last but one to the last, on the line between them.
std::size_t addBeside(OpacityPoints& points, std::size_t point);
/// Moves a point, but not past its neighbors.
std::size_t movePoint(OpacityPoints& points, std::size_t point, const OpacityPoint& to);
/// Two points always remain.
std::size_t removePoint(OpacityPoints& points, std::size_t point);

} // namespace vp::render
