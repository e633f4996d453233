#include "faults.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace vp::layer
{

Faults::Faults()
{
	const char* set = std::getenv("VPROBE_LAYER_FAULT");
	if (!set)
		return;
	const std::string text = set;
	const std::size_t colon = text.find(':');
	const std::string kind = text.substr(0, colon);
	kind_ = kind == "host" ? kHostMemory : kind == "device" ? kDeviceMemory : kind == "lost" ? kLost : 0u;
	if (kind_ == 0 || colon == std::string::npos)
	{
		std::fprintf(stderr, "VPROBE_LAYER_FAULT: host:N, device:N or lost:N, not %s\n", set);
		std::_Exit(99);
	}
	at_ = std::strtoull(&text[colon + 1], nullptr, 10);
}

Faults::~Faults()
{
	const char* file = std::getenv("VPROBE_LAYER_COUNT");
	if (!file)
		return;
	if (std::FILE* out = std::fopen(file, "w"))
	{
		std::fprintf(out, "%llu\n", static_cast<unsigned long long>(calls_.load()));
		std::fclose(out);
	}
}

std::optional<VkResult> Faults::next(unsigned bits)
{
	if ((bits & kind_) == 0)
		return {};
	const std::uint64_t call = ++calls_;
	if (kind_ == kLost)
	{
		if (call == at_)
			is_lost_ = true;
		return is_lost_ ? std::optional(VK_ERROR_DEVICE_LOST) : std::nullopt;
	}
	if (call != at_)
		return {};
	return kind_ == kHostMemory ? VK_ERROR_OUT_OF_HOST_MEMORY : VK_ERROR_OUT_OF_DEVICE_MEMORY;
}

} // namespace vp::layer
