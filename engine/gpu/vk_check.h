#pragma once

#include "base/result.h"
#include "gpu/vulkan.h"

namespace vp::gpu
{

// Out of memory and a lost device come back as an Error, since a caller can go on without; any other failure is our
// mistake: it names the call and ends the program, in release too. Success codes (VK_NOT_READY, VK_SUBOPTIMAL_KHR …)
// pass.
Status check(VkResult result, const char* call);

// For calls that can fail with our mistakes only.
void require(VkResult result, const char* call);

const char* resultName(VkResult result);

} // namespace vp::gpu
