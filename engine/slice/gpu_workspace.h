#pragma once

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/shader.h"
#include "gpu/timers.h"

#include <cstddef>

namespace vp::slice
{

constexpr std::size_t roundUp(std::size_t value, std::size_t step)
{
	return (value + step - 1) / step * step;
}

// What one slice under way needs on the device, kept from slice to slice: nothing is made per generation but where a
// front outgrows all before it.
struct ClassifyWorkspace
{
	explicit ClassifyWorkspace(gpu::Device& device) : timers(device, "GPU cut") {}

	// Made by the first slice.
	Status prepare(gpu::Device& device, const gpu::Pipeline& pipeline);
	// Room for so many cells of a generation, over all lanes. What is in the buffers is lost.
	Status reserveFront(gpu::Device& device, std::size_t cells);
	// Room for what stays the same during a slice.
	Status reserveLanes(gpu::Device& device, std::size_t bytes);
	Status reserveAxes(gpu::Device& device, std::size_t texels);

	gpu::Commands commands;
	gpu::DescriptorSets sets; // set i serves dispatch i of a generation
	gpu::Timers timers;
	gpu::Buffer front; // cell ids, written by the host
	gpu::Buffer words; // read by the host
	gpu::Buffer lanes; // ClassifyLane each, at offsets that the device can bind
	gpu::Buffer axes;
	gpu::TexelView axis_texels;
};

} // namespace vp::slice
