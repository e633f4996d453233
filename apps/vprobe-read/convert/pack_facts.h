#pragma once

#include "grid/field.h"

#include <cstdint>
#include <vector>

#include <hdf5.h>

namespace vp::reader::convert
{

// Gathers what a pack says of all values of an array, time by time (docs/FORMATS.md).
class PackFacts
{
public:
	// Takes the values at the next time.
	void include(const grid::Field& values);
	// Writes into the array's group. Throws NoRoom.
	void write(hid_t group, bool with_times) const;

private:
	std::vector<double> spans_;          // rows of four
	std::vector<double> least_positive_; // for each of these rows
	std::vector<double> values_;
	std::vector<std::uint32_t> value_counts_; // for each time
	std::vector<std::uint64_t> changes_;      // two for each time
};

} // namespace vp::reader::convert
