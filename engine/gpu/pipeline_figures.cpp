#include "gpu/pipeline_figures.h"

#include "gpu/device.h"

#include <atomic>
#include <mutex>

namespace vp::gpu
{

namespace
{

std::atomic<bool> keeps_figures = false;

struct KeptFigures
{
	std::mutex mutex;
	std::vector<ExecutableFigures> all;
};

KeptFigures& keptFigures()
{
	static KeptFigures kept;
	return kept;
}

template <class Function>
Function deviceFunctionOf(const Device& device, const char* name)
{
	return reinterpret_cast<Function>(vkGetDeviceProcAddr(device.handle(), name));
}

double numberOf(const VkPipelineExecutableStatisticKHR& told)
{
	switch (told.format)
	{
	case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
		return told.value.b32 ? 1.0 : 0.0;
	case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
		return static_cast<double>(told.value.i64);
	case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR:
		return static_cast<double>(told.value.u64);
	default:
		return told.value.f64;
	}
}

std::vector<std::pair<std::string, double>> figuresOf(const Device& device, VkPipeline pipeline, std::uint32_t number)
{
	const auto ask =
	    deviceFunctionOf<PFN_vkGetPipelineExecutableStatisticsKHR>(device, "vkGetPipelineExecutableStatisticsKHR");
	const VkPipelineExecutableInfoKHR which{VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR, nullptr, pipeline, number};
	std::uint32_t count = 0;
	if (!ask || ask(device.handle(), &which, &count, nullptr) != VK_SUCCESS)
		return {};
	std::vector<VkPipelineExecutableStatisticKHR> told(count, {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR});
	if (ask(device.handle(), &which, &count, told.data()) < 0)
		return {};
	told.resize(count);
	std::vector<std::pair<std::string, double>> figures;
	for (const VkPipelineExecutableStatisticKHR& one : told)
		figures.emplace_back(one.name, numberOf(one));
	return figures;
}

} // namespace

void keepPipelineFigures(bool on)
{
	keeps_figures = on;
}

bool keepsPipelineFigures()
{
	return keeps_figures.load(std::memory_order_relaxed);
}

std::vector<ExecutableFigures> pipelineFigures()
{
	const std::lock_guard lock(keptFigures().mutex);
	return keptFigures().all;
}

bool tellsPipelineFigures(const Device& device)
{
	return keepsPipelineFigures() && deviceFunctionOf<PFN_vkGetPipelineExecutablePropertiesKHR>(
	                                     device, "vkGetPipelineExecutablePropertiesKHR") != nullptr;
}

void addPipelineFigures(const Device& device, VkPipeline pipeline, std::string_view name)
{
	const auto ask =
	    deviceFunctionOf<PFN_vkGetPipelineExecutablePropertiesKHR>(device, "vkGetPipelineExecutablePropertiesKHR");
	const VkPipelineInfoKHR which{VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, nullptr, pipeline};
	std::uint32_t count = 0;
	if (!ask || ask(device.handle(), &which, &count, nullptr) != VK_SUCCESS)
		return;
	std::vector<VkPipelineExecutablePropertiesKHR> told(count, {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR});
	if (ask(device.handle(), &which, &count, told.data()) < 0)
		return;
	told.resize(count);
	for (std::uint32_t e = 0; e < told.size(); ++e)
	{
		ExecutableFigures figures{std::string(name), told[e].name, told[e].subgroupSize,
		                          figuresOf(device, pipeline, e)};
		const std::lock_guard lock(keptFigures().mutex);
		keptFigures().all.push_back(std::move(figures));
	}
}

} // namespace vp::gpu
