#pragma once

#include "base/huge_vector.h"
#include "base/parallel_for.h"
#include "grid/block.h"

#include <tbb/blocked_range.h>

#include <cstddef>
#include <memory>
#include <vector>

// Tools to make the built-in data sets.
namespace vp::grid::demo
{

// Half the edge of the boxes of blob, graded and mixed.
constexpr double kHalf = 3.0;

// Memory in huge pages that is not touched before the threads that fill it do so.
template <class T>
struct Filled
{
	std::shared_ptr<HugeVector<T>> data;
	std::size_t size;

	explicit Filled(std::size_t count) : data(std::make_shared<HugeVector<T>>(count)), size(count) {}
	T& operator[](std::size_t i) const { return (*data)[i]; }
	Array<T> array() const { return Array<T>(data, data->data(), size); }
	Array<std::byte> bytes() const
	{
		return Array<std::byte>(data, reinterpret_cast<const std::byte*>(data->data()), size * sizeof(T));
	}
};

// The points of a lattice of n cells each way.
struct LatticePoints
{
	std::size_t side;

	explicit LatticePoints(int n) : side(n + 1) {}
	std::size_t count() const { return side * side * side; }
	std::size_t operator()(std::size_t i, std::size_t j, std::size_t k) const { return (k * side + j) * side + i; }
};

// Calls body(j, k) for the rows of `side` x `side`.
template <class Body>
void forRows(std::size_t side, Body&& body)
{
	parallelFor(tbb::blocked_range<std::size_t>(0, side * side, 16),
	            [&](const tbb::blocked_range<std::size_t>& rows)
	            {
		            for (std::size_t row = rows.begin(); row < rows.end(); ++row)
			            body(row % side, row / side);
	            });
}

struct FieldsOfPoints
{
	Filled<float> s;
	Filled<float> v;

	explicit FieldsOfPoints(std::size_t points) : s(points), v(3 * points) {}
	void set(std::size_t p, double sin_3x, double cos_2y, const Vec3& at) const
	{
		s[p] = static_cast<float>(sin_3x * cos_2y + 0.5 * at.z);
		v[3 * p] = static_cast<float>(-at.y);
		v[3 * p + 1] = static_cast<float>(at.x);
		v[3 * p + 2] = 0.3f;
	}
	std::vector<Field> fields() const
	{
		return {{"s", Association::point, 1, NumberType::float32, s.bytes()},
		        {"v", Association::point, 3, NumberType::float32, v.bytes()}};
	}
};

// Returns the arrays at the coordinates as they are stored.
std::vector<Field> fieldsAt(const Filled<float>& xyz);

// The points and the data sets have n cells each way.
Filled<float> shellPoints(int n);
// The boundary layer on the upper side of a swept wing: cells at the wall are ten thousand times as long as high, those
// at the outside as high as long.
Filled<float> layerPoints(int n);
Block makeHexes(int n);
Block makeTets(int n);
Block makeMixed(int n);
Block makeLayer(int n);

} // namespace vp::grid::demo
