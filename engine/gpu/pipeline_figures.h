#pragma once

#include "gpu/vulkan.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vp::gpu
{

class Device; // device.h

// The figures of a driver for one shader of a pipeline that it has compiled (VK_KHR_pipeline_executable_properties):
// its registers, instructions and whatever else, in the driver's own words.
struct ExecutableFigures
{
	std::string pipeline;
	std::string executable;
	std::uint32_t subgroup_size = 0;
	std::vector<std::pair<std::string, double>> figures;
};

// Off at first, since a driver may compile anew for it. Turn it on before the device is opened. It belongs to the
// process.
void keepPipelineFigures(bool on);
bool keepsPipelineFigures();
/// Returns the figures of all pipelines that were made while it was on, in the order of their making.
std::vector<ExecutableFigures> pipelineFigures();

/// Returns true if the device was opened with the extension.
bool tellsPipelineFigures(const Device& device);
void addPipelineFigures(const Device& device, VkPipeline pipeline, std::string_view name);

} // namespace vp::gpu
