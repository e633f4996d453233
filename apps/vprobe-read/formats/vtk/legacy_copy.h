#pragma once

#include "vprobe-read/base/memory_file.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::vtk
{

// A copy in memory of a legacy VTK file, which VTK's reader reads in place of it.
struct LegacyCopy
{
	std::unique_ptr<MemoryFile> file; // null: the file itself is read right
	std::vector<std::string> warnings;
	bool is_text = false;
};

// VTK 9.1 does not know nan, 1D2 and 1.0-100 in legacy files, not even in the descriptions of arrays that its own
// writer adds, and keeps one of two arrays that have the same name. So text becomes bytes, and each array gets its own
// name. Throws a Refusal for a word that is no number, and for too few or too many values. Data sets that are no
// grids, and keywords that VTK's reader has to tell about, stay what they are.
LegacyCopy copyLegacy(std::string_view text);

} // namespace vp::reader::vtk
