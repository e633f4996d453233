#pragma once

#include "base/result.h"
#include "gpu/vulkan.h"

namespace vp::gpu
{

/// The Error of a call that failed: out_of_memory, device where it is lost, and else internal, since any other failure
/// is a mistake of ours. Success codes (VK_NOT_READY, VK_SUBOPTIMAL_KHR …) pass.
Status check(VkResult result, const char* call);

/// Repeats a wait that memory ran out for. Giving up would mean that what the device works on is freed.
template <class Wait>
VkResult patiently(const Wait& wait)
{
	constexpr int kTries = 8;
	VkResult result = wait();
	for (int i = 1; i < kTries && (result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY);
	     ++i)
		result = wait();
	return result;
}

/// For calls whose callers have no way to hand an Error on: throws std::runtime_error with the same message.
void require(VkResult result, const char* call);

const char* resultName(VkResult result);

} // namespace vp::gpu
