#pragma once

#include "grid/block.h"
#include "grid/field.h"

#include <string>
#include <vector>

namespace vp::write
{

// An array of a block set, known by its name and association.
struct SetArray
{
	std::string name;
	int components = 0;                        // of the widest
	grid::NumberType type;                     // float64 where blocks differ
	bool categorical;                          // in every block, of one type
	std::vector<const grid::Field*> per_block; // null where a block lacks it
};

// In the order in which the blocks have them.
std::vector<SetArray> arraysOf(const grid::BlockSet& blocks, grid::Association association);

// Of values between points: float32 for sources that fit (float32, integers of up to 16 bits), else float64; of a
// categorical array, which is not interpolated, its own.
grid::NumberType interpolatedType(const SetArray& array);

// name, name_x, name_0 …
std::string componentName(const std::string& name, int components, int component);

} // namespace vp::write
