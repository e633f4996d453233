#pragma once

#include "plot3d_layout.h"
#include "vprobe-read/base/memory_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::wrapped
{

// The numbers of a text that Fortran wrote: blanks or commas stand between them, 3*0.5 is three of them, and each may
// be written in every way of base/real_text.h. Throws a Refusal for a word that is no number.
std::vector<double> fortranNumbers(std::string_view text);

// Writes a grid file, or a solution on it, as bytes that VTK's reader takes as little endian doubles: it does not know
// nan, 1.0-100 and 3*0.5 in text. Throws a Refusal where the numbers are too few or too many.
void writeGridAsBytes(const std::vector<double>& numbers, const Plot3dLayout& layout, MemoryFile& to);
void writeSolutionAsBytes(const std::vector<double>& numbers, const Plot3dLayout& grid, const std::string& name,
                          MemoryFile& to);

} // namespace vp::reader::wrapped
