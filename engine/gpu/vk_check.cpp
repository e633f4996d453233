#include "gpu/vk_check.h"

#include <fmt/format.h>

#include <stdexcept>

namespace vp::gpu
{

const char* resultName(VkResult result)
{
	switch (result)
	{
	case VK_ERROR_OUT_OF_HOST_MEMORY:
		return "out of host memory";
	case VK_ERROR_OUT_OF_DEVICE_MEMORY:
		return "out of device memory";
	case VK_ERROR_DEVICE_LOST:
		return "device lost";
	case VK_ERROR_INITIALIZATION_FAILED:
		return "initialisation failed";
	case VK_ERROR_LAYER_NOT_PRESENT:
		return "layer not present";
	case VK_ERROR_EXTENSION_NOT_PRESENT:
		return "extension not present";
	case VK_ERROR_FEATURE_NOT_PRESENT:
		return "feature not present";
	case VK_ERROR_INCOMPATIBLE_DRIVER:
		return "incompatible driver";
	case VK_ERROR_OUT_OF_DATE_KHR:
		return "swapchain out of date";
	case VK_ERROR_SURFACE_LOST_KHR:
		return "surface lost";
	default:
		return "failed";
	}
}

Status check(VkResult result, const char* call)
{
	if (result >= 0)
		return Nothing{};
	switch (result)
	{
	case VK_ERROR_OUT_OF_HOST_MEMORY:
	case VK_ERROR_OUT_OF_DEVICE_MEMORY:
		return Error{ErrorKind::out_of_memory,
		             fmt::format("{} ({}); `classify` cpu, a smaller `size` or another `device` may do",
		                         resultName(result), call)};
	case VK_ERROR_DEVICE_LOST:
	case VK_ERROR_SURFACE_LOST_KHR:
		return Error{ErrorKind::device, fmt::format("{} ({}); the driver's log may say why; try again, or with "
		                                            "another `device`",
		                                            resultName(result), call)};
	default:
		return Error{ErrorKind::internal, fmt::format("{}: {} ({}); this is a mistake in the program, please report it",
		                                              call, resultName(result), static_cast<int>(result))};
	}
}

void require(VkResult result, const char* call)
{
	if (const Status done = check(result, call); !done)
		throw std::runtime_error(done.error().message);
}

} // namespace vp::gpu
