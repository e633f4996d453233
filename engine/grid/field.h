#pragma once

#include "base/array.h"
#include "parts/part_store.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
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
std::optional<NumberType> parseNumberType(std::string_view name);

enum class Association : std::uint8_t
{
	point,
	cell
};

const char* associationName(Association association); // "point", "cell"

// The number of a tuple that is shown is one component, or, with this, the length of the tuple. The length of a
// symmetric tensor of six components is that of all nine.
constexpr int kMagnitude = -1;

// The smallest and the largest finite value, and whether there are infinite ones. NaN is ignored.
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

struct ArrayFacts; // array_facts.h

// An array of values over the points or the cells of a block, in the numbering and number type of its source:
// index it with sourcePoint(p) or sourceCell(c). `bytes` holds tuples() x components numbers, unless they stay in their
// file: then `bytes` is empty, and `stored` holds a tuple as each item.
struct Field
{
	std::string name;
	Association association = Association::point;
	int components = 1;
	NumberType type = NumberType::float32;
	Array<std::byte> bytes;
	bool categorical = false; // see namesCategories(); set when a block takes its fields
	std::string units{};      // as in the file, mostly empty
	std::shared_ptr<const parts::PartStore> stored{};
	std::shared_ptr<const ArrayFacts> facts{}; // if the file says them
	bool is_in_runs = false;                   // only values of cells that were fetched are here (grid/cell_runs.h)

	std::size_t tuples() const;
	// Returns the numbers of a tuple, one after the other, with no promise about alignment. Those of a stored array may
	// be read for this, and stay valid until this thread has asked for some others (parts::PartStore::item). The caller
	// checks the bounds.
	const std::byte* tuple(std::size_t number) const;
	double value(std::size_t tuple, int component) const; // the caller checks the bounds
	// Tells an array from others and from what held other values before.
	const void* identity() const { return stored ? static_cast<const void*>(stored.get()) : bytes.data(); }
};

// Returns the array with all its values in memory.
Field inMemory(const Field& field);

// Returns true if the numbers of an array are names of categories, with nothing between two of them. Such an array has
// an integer type, and one word of its name is id, ids, material, materials, label, labels, region, regions, zone,
// zones, category, categories, segment, segmentation, partition, flag, flags or type. Signs, digits and capitals
// separate words.
bool namesCategories(const Field& field);

// Writes a number in the given type. Integers are rounded towards zero, and NaN becomes 0.
void storeNumber(NumberType type, double value, std::byte* at);

double loadNumber(NumberType type, const std::byte* at);

template <class T>
Field makeField(std::string name, Association association, int components, std::vector<T> values);

// Returns the span of the shown values. component: 0.. or kMagnitude.
ValueSpan valueSpan(const Field& field, int component);

// Returns the range() of that span: {0, 0} if no value is finite.
std::pair<double, double> fieldRange(const Field& field, int component);

} // namespace vp::grid
