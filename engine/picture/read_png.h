#pragma once

#include "base/result.h"
#include "render/picture.h"

#include <string>

namespace vp::picture
{

/// Reads a PNG of 8 bits a channel to compare it with a picture of ours. Gray pictures and palettes become RGBA. A file
/// with 16 bits a channel, or larger than any picture of ours, is an input error.
Result<render::Picture> readPng(const std::string& path);

} // namespace vp::picture
