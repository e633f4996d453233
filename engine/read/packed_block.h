#pragma once

#include "grid/block.h"
#include "read/manifest.h"
#include "read/stored_array.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>

namespace vp::read
{

// Returns all that a pack says of its whole but the `cell_numbers`. Throws Unusable.
grid::WholeGrid wholeOf(const nlohmann::json& pack, const SharedBytes& arrays);

// Takes a block of a pack whose cells stay in its file (protocol.h): its cells, arrays and facts, but none of their
// values. Throws Unusable, and parts::Unreadable if the file cannot be opened.
void takePackedBlock(const nlohmann::json& block, const SharedBytes& arrays, const ReadableFiles& files,
                     CheckedBlock& checked);

} // namespace vp::read
