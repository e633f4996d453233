#pragma once

#include "base/array.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vp::grid
{

enum class NumberType : std::uint8_t
{
	int8,
	uint8,
	int16,
	uint16,
	int32,
	uint32,
	int64,
	uint64,
	float32,
	float64
};

std::size_t byteSize(NumberType type);
const char* numberTypeName(NumberType type); // "float32" …

enum class Association : std::uint8_t
{
	point,
	cell
};

const char* associationName(Association association); // "point", "cell"

// An array of values over the points or the cells of a block, in the numbering and number type of its source:
// index it with sourcePoint(p) or sourceCell(c). `bytes` holds tuples() x components numbers.
struct Field
{
	std::string name;
	Association association = Association::point;
	int components = 1;
	NumberType type = NumberType::float32;
	Array<std::byte> bytes;
	bool categorical = false; // see namesCategories(); set where a block takes its fields
	std::string units{};      // as the file names them, mostly empty

	std::size_t tuples() const;
	double value(std::size_t tuple, int component) const; // bounds are the caller's
};

// Whether the numbers of an array are names, with nothing in between: of integer type, and called so. One of the words
// of its name (parted by signs, digits and capitals) is id, ids, material, materials, label, labels,
// region, regions, zone, zones, category, categories, segment, segmentation, partition, flag, flags or type.
bool namesCategories(const Field& field);

// Writes a number of the type; integers are rounded towards zero, and NaN as an integer is 0.
void storeNumber(NumberType type, double value, std::byte* at);

double loadNumber(NumberType type, const std::byte* at);

template <class T>
Field makeField(std::string name, Association association, int components, std::vector<T> values);

// Which number of a tuple is shown: one component, or the length of the tuple.
constexpr int kMagnitude = -1;

// Smallest and largest of finite values, and whether infinite ones are beside them; NaN counts as none.
struct ValueSpan
{
	double lo = std::numeric_limits<double>::infinity();
	double hi = -std::numeric_limits<double>::infinity();
	bool minus_infinity = false;
	bool plus_infinity = false;

	bool empty() const { return lo > hi; }
	std::pair<double, double> range() const { return empty() ? std::pair{0.0, 0.0} : std::pair{lo, hi}; }
	void include(double value);
	void include(const ValueSpan& other);
};

// Of the shown values. component: 0.. or kMagnitude.
ValueSpan valueSpan(const Field& field, int component);

// Its range(): {0, 0} where no value is finite.
std::pair<double, double> fieldRange(const Field& field, int component);

} // namespace vp::grid
