#pragma once

#include "vprobe-read/base/refusal.h"
#include "zarr_layout.h"

#include <cstddef>
#include <string>
#include <vector>

namespace vp::reader::volumes
{

// The words that the JSON of Zarr's versions and of N5 have in common.

constexpr std::size_t kMaxSidesOfZarr = 32; // as many as NumPy has

// name: of the array, here and below.
Refusal notFollowedZarr(const std::string& name);

// Returns the numbers of a list. Throws a Refusal unless it is one of sides.
std::vector<std::size_t> zarrSides(const nlohmann::json& given, const std::string& name);

// Returns the type "uint16" or the like, in the order of bytes of this machine. Kind 0 for others.
ZarrType zarrTypeNamed(const std::string& name);

ZarrLayout layoutOfN5(const nlohmann::json& about, const std::string& name);

} // namespace vp::reader::volumes
