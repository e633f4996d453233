#pragma once

#include "base/array.h"
#include "base/vec.h"

#include <cstddef>

namespace vp::grid
{

// Coordinates x, y, z per point, kept as float or double as they came: no precision is lost, no memory spent on it.
class Points
{
public:
	Points() = default;
	explicit Points(Array<float> xyz) : float_(std::move(xyz)), count_(float_.size() / 3) {}
	explicit Points(Array<double> xyz) : double_(std::move(xyz)), count_(double_.size() / 3), is_double_(true) {}

	std::size_t size() const { return count_; }
	bool isDouble() const { return is_double_; }
	// The numbers as they are kept, x y z of the first point first; null of the other type.
	const float* floats() const { return is_double_ ? nullptr : float_.data(); }
	const double* doubles() const { return is_double_ ? double_.data() : nullptr; }
	Vec3 operator[](std::size_t i) const
	{
		// The branch goes the same way for a whole cut and costs next to nothing beside the cache miss.
		if (is_double_)
			return {double_[3 * i], double_[3 * i + 1], double_[3 * i + 2]};
		return {float_[3 * i], float_[3 * i + 1], float_[3 * i + 2]};
	}

private:
	Array<float> float_;
	Array<double> double_;
	std::size_t count_ = 0;
	bool is_double_ = false;
};

} // namespace vp::grid
