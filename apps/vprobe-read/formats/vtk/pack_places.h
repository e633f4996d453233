#pragma once

#include "pack_index.h"

#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace vp::reader::vtk
{

// Runs of a pack, from `begin` to before `end`.
struct PackRange
{
	std::size_t begin = 0;
	std::size_t end = 0;
};

// Chooses some of the runs, which have so many cells together, or nothing.
using ChoosePackRuns = std::function<std::optional<PackRange>(std::size_t runs, std::uint64_t cells)>;

// Describes where the lists of a pack lie in its file, as a block of the manifest of kind "packed" (protocol.h) without
// its name. Returns nothing if they do not lie there as they are in memory, or if cells that nobody sees lie between
// others, and null if none of its runs were chosen.
std::optional<nlohmann::json> describePlaces(const PackIndex& index, const std::string& file,
                                             const ChoosePackRuns& choose, arrays::Writer& writer);

} // namespace vp::reader::vtk
