#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace vp::gpu
{

// How often the shaders of a pass ran, as the device counts it (VK_QUERY_TYPE_PIPELINE_STATISTICS).
struct Invocations
{
	std::uint64_t vertices = 0;  // vertices that were assembled
	std::uint64_t fragments = 0; // runs of fragment shaders
	std::uint64_t computes = 0;  // runs of compute shaders

	bool operator==(const Invocations&) const = default;
};

using PassInvocations = std::map<std::string, Invocations, std::less<>>; // by the name of the pass

// Counting is off at first, since some devices become slower by it. It belongs to the process: so only one profile at a
// time may count. Devices without the feature pipelineStatisticsQuery count nothing.
void countInvocations(bool on);
bool countsInvocations();
void addInvocations(const char* pass, const Invocations& more);
// Returns the counts since the last call. Passes count when their timers are collected (timers.h).
PassInvocations takeInvocations();

} // namespace vp::gpu
