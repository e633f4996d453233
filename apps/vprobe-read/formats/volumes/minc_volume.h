#pragma once

#include <array>
#include <string>
#include <vector>

namespace vp::reader::volumes
{

// A dimension of a MINC image.
struct MincAxis
{
	std::string name; // xspace, yspace, zspace, time, vector_dimension
	std::size_t count = 0;
	double start = 0.0;
	double step = 1.0;
	std::array<double, 3> direction{}; // the direction of the axis in space
	std::string units;
};

// An image as its file has it: the first axis runs slowest.
struct MincVolume
{
	std::vector<MincAxis> axes;
	std::vector<double> values;
	bool is_float = false; // such values need no scale
	std::array<double, 2> valid{0.0, 0.0};
	// The meanings of the least and the greatest valid value: for the whole, or for each of the first axes' slices.
	std::vector<double> least{0.0};
	std::vector<double> greatest{1.0};
};

MincVolume readMinc2(const std::string& file);
// Version 1 is netCDF.
MincVolume readMinc1(const std::string& file);

} // namespace vp::reader::volumes
