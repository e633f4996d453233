#pragma once

#include "grid/field.h"

#include <cmath>

namespace vp::grid
{

// Returns how often the square of a component counts in the magnitude of a tuple. Six components are a symmetric
// tensor, xx yy zz xy yz xz, whose last three stand for two each.
constexpr double magnitudeWeight(int components, int c)
{
	return components == 6 && c >= 3 ? 2.0 : 1.0;
}

// Returns the shown number of a tuple. at(c) returns its components. component: 0.. or kMagnitude.
template <class At>
double shownValue(int components, int component, At&& at)
{
	if (component != kMagnitude)
		return at(component);
	if (components == 1)
		return std::abs(at(0));
	double sum = 0.0;
	for (int c = 0; c < components; ++c)
		sum += magnitudeWeight(components, c) * at(c) * at(c);
	return std::sqrt(sum);
}

// The same of the numbers of a tuple of the field.
inline double shownValue(const Field& field, const std::byte* tuple, int component)
{
	return shownValue(field.components, component,
	                  [&](int c) { return loadNumber(field.type, tuple + c * byteSize(field.type)); });
}

inline double shownValue(const Field& field, std::size_t tuple, int component)
{
	return shownValue(field.components, component, [&](int c) { return field.value(tuple, c); });
}

} // namespace vp::grid
