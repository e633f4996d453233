#pragma once

#include <cstdint>
#include <string_view>

namespace vp::reader::volumes
{

// Whether a JPEG 2000 codestream of a picture of this size is whole: its markers, the lengths of its tile-parts, and
// all of its tiles. What its packets hold has no checksum. Other data (in a JP2 box, say) are not looked at: true.
bool isWholeJpeg2000(std::string_view bytes, std::uint32_t columns, std::uint32_t rows, std::uint32_t samples);

} // namespace vp::reader::volumes
