#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace vp::shaders
{

// The SPIR-V of a shader by its file name, as "classify_single.comp"; with ".storage" behind it, of the one that reads
// arrays from storage buffers (arrays.glsl). Empty where there is none of that name.
std::span<const std::uint32_t> spirv(std::string_view name);

// classify_expression.glsl with all that it includes; a definition of surfaceAt() is to follow.
// storage: reads arrays from storage buffers.
std::string_view classifyExpressionSource(bool storage);

} // namespace vp::shaders
