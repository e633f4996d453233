#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace vp::reader::arrays
{

// Codecs that chunks of HDF5 and of Zarr have in common, undone. Each returns false unless the packed bytes give
// exactly as many as `to` has.

bool inflateZlib(std::span<const std::byte> packed, std::span<std::byte> to);
bool inflateGzip(std::span<const std::byte> packed, std::span<std::byte> to);
bool unpackBlosc(std::span<const std::byte> packed, std::span<std::byte> to);
// All first bytes of the elements come first, then all second ones; a rest that fills no element stays as it is.
bool unshuffle(std::span<const std::byte> packed, std::span<std::byte> to, std::size_t width);

// Returns the checksum CRC-32C (RFC 3720, appendix B.4).
std::uint32_t crc32c(std::span<const std::byte> bytes);

} // namespace vp::reader::arrays
