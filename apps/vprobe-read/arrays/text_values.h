#pragma once

#include "value_image.h"

// Numbers in text, with blanks or commas between them. Throws a Refusal unless the text has exactly `count` of them,
// each one that the type can hold. `to` has room for all.
void parseText(std::string_view text, vp::grid::NumberType type, std::uint64_t count, void* to);

// An array of the values of one of several steps that follow each other.
vtkSmartPointer<vtkDataArray> arrayOfText(std::string_view text, const ValueLayout& layout, std::uint64_t step,
                                          std::uint64_t steps, const std::string& name);
