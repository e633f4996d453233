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
	int components = 0;                        // components of the widest array
	grid::NumberType type;                     // float64 if blocks differ
	bool categorical;                          // categorical in every block, with one type
	std::vector<const grid::Field*> per_block; // null if a block lacks it
};

// Returns the arrays in the order in which the blocks have them.
std::vector<SetArray> arraysOf(const grid::BlockSet& blocks, grid::Association association);

// Returns the type of values between points: float32 for sources that fit (float32, integers of up to 16 bits), else
// float64. A categorical array is not interpolated and keeps its type.
grid::NumberType interpolatedType(const SetArray& array);

// name, name_x, name_0 …
std::string componentName(const std::string& name, int components, int component);

} // namespace vp::write
