#pragma once

#include "foam_case.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace vp::reader::codes
{

// The parts of a case that was decomposed among processors.
struct FoamParts
{
	std::vector<FoamPlace> places;        // one for each processor, in their order; none if the case is not decomposed
	std::vector<FoamTime> times;          // those that all parts have, ascending
	std::size_t unfinished = 0;           // how many times only some parts have
	std::optional<std::size_t> missing{}; // the first processor whose part is not there, while those of others are
};

// Finds processor0, processor1 and so on in the folder of a case, or processorsN with files for N processors. Of
// several decompositions it takes the one that has the latest time.
FoamParts foamParts(const std::filesystem::path& folder);

} // namespace vp::reader::codes
