#pragma once

#include "read/read.h"

#include <string>

namespace vp::read
{

// The index of a file lies beside it and is called like it, with kIndexEnding, or in the user's cache folder. It is a
// pack without the values of arrays (docs/FORMATS.md), so cuts read what they need of it, and the values where they
// are.

// Says whether indices are used from now on. VPROBE_INDEX=off turns them off until somebody calls this. No setting,
// since a state is not to say whom to trust.
void setUsesIndices(bool uses);

// Returns where the index of a file lies, beside it and in the cache folder, whether it is there or not. The second is
// empty if the user has no such folder; its folder may have to be made.
std::string indexBeside(const std::string& file);
std::string indexInCache(const std::string& file);

// Returns the index by which a file may be read with these options, or nothing if there is none, or if it is of another
// user than the file and this process. Whether it fits the file is known when it is read.
std::string indexOf(const std::string& file, const ReadOptions& options);

} // namespace vp::read
