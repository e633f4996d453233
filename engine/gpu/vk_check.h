#pragma once

#include "base/result.h"
#include "gpu/vulkan.h"

namespace vp::gpu
{

/// The Error of a call that failed: out_of_memory, device where it is lost, and else internal, since any other failure
/// is a mistake of ours. Success codes (VK_NOT_READY, VK_SUBOPTIMAL_KHR …) pass.
Status check(VkResult result, const char* call);

/// For calls whose callers have no way to hand an Error on: throws std::runtime_error with the same message.
void require(VkResult result, const char* call);

const char* resultName(VkResult result);

} // namespace vp::gpu
