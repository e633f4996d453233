#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <hdf5.h>

namespace vp::reader::convert
{

// An array of a pack with several times, which has so many rows at each of them.
struct StepsOfArray
{
	bool on_points;
	std::string name;
	hsize_t rows;
};

// Says where the values of each time are, as VTKHDF 2.0 does. All times have the same points and cells, in so many
// partitions, and maybe polyhedra. root: the group of the data set. Throws NoRoom.
void writePackSteps(hid_t root, const std::vector<double>& times, std::size_t partitions, bool has_polyhedra,
                    std::span<const StepsOfArray> arrays);

} // namespace vp::reader::convert
