#pragma once

#include "value_image.h"

namespace vp::reader::arrays
{

// Reads numbers in text, with blanks or commas between them. Throws a Refusal unless the text has exactly `count`
// numbers that the type can hold. `to` must have room for all.
void parseText(std::string_view text, grid::NumberType type, std::uint64_t count, void* to);

// Returns the values of one step. The text holds several steps, one after the other.
vtkSmartPointer<vtkDataArray> arrayOfText(std::string_view text, const ValueLayout& layout, std::uint64_t step,
                                          std::uint64_t steps, const std::string& name);

} // namespace vp::reader::arrays
