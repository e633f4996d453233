#pragma once

#include "grid/field.h"

#include <cstddef>

namespace vp::read
{

// A pack says for each run of cells between which values those of its points lie (RunRanges of docs/FORMATS.md): for
// each component, and last for the length of a tuple if there are several.

inline std::size_t columnsOfRanges(int components)
{
	return static_cast<std::size_t>(components > 1 ? components + 1 : 1);
}

inline std::size_t bytesOfRanges(const grid::Field& field)
{
	return columnsOfRanges(field.components) * 2 * sizeof(float);
}

} // namespace vp::read
