#pragma once

#include "packed_array.h"

namespace vp::reader::arrays
{

// Unpacks one block. Returns false unless it fills `to` exactly.
bool unpack(Codec codec, std::span<const std::byte> packed, std::span<std::byte> to);

} // namespace vp::reader::arrays
