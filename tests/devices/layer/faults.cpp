#include "faults.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace vp::layer
{

namespace
{

struct FaultKind
{
	std::string_view name;
	unsigned bit;
	VkResult result;
};

constexpr FaultKind kFaultKinds[] = {{"host", kHostMemory, VK_ERROR_OUT_OF_HOST_MEMORY},
                                     {"device", kDeviceMemory, VK_ERROR_OUT_OF_DEVICE_MEMORY},
                                     {"lost", kLost, VK_ERROR_DEVICE_LOST},
                                     {"surface", kSurface, VK_ERROR_SURFACE_LOST_KHR},
                                     {"date", kOutOfDate, VK_ERROR_OUT_OF_DATE_KHR},
                                     {"late", kLate, VK_TIMEOUT}};

} // namespace

Faults::Faults()
{
	const char* set = std::getenv("VPROBE_LAYER_FAULT");
	if (!set)
		return;
	const std::string text = set;
	const std::size_t colon = text.find(':');
	for (const FaultKind& kind : kFaultKinds)
		if (text.substr(0, colon) == kind.name)
		{
			kind_ = kind.bit;
			result_ = kind.result;
		}
	if (kind_ == 0 || colon == std::string::npos)
	{
		std::fprintf(stderr, "VPROBE_LAYER_FAULT: host:N, device:N, lost:N, surface:N, date:N or late:N, not %s\n",
		             set);
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
	if (call == at_ && (kind_ & (kLost | kSurface)) != 0)
		is_lost_ = true;
	return call == at_ || is_lost_ ? std::optional(result_) : std::nullopt;
}

} // namespace vp::layer
