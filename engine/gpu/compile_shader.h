#pragma once

#include "base/result.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vp::gpu
{

// GLSL of a compute shader, without #include, to SPIR-V for Vulkan 1.3. Thread safe. The source is the program's own
// making: an error, with the compiler's first line, is a fault of ours or of a limit of the compiler.
Result<std::vector<std::uint32_t>> compileComputeShader(const std::string& source);

} // namespace vp::gpu
