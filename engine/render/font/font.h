#pragma once

#include <cstddef>
#include <span>

namespace vp::render
{

// Returns the TrueType file of DejaVu Sans.
std::span<const std::byte> fontFile();

} // namespace vp::render
