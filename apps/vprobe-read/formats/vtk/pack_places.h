#pragma once

#include "pack_index.h"

#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace vp::reader::vtk
{

// Describes where the lists of a pack lie in its file, as a block of the manifest of kind "packed" (protocol.h) without
// its name. Returns nothing if they do not lie there as they are in memory, or if cells that nobody sees lie between
// others.
std::optional<nlohmann::json> describePlaces(const PackIndex& index, const std::string& file, arrays::Writer& writer);

} // namespace vp::reader::vtk
