#pragma once

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/shader.h"
#include "gpu/shader_array.h"
#include "gpu/timers.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace vp::classify
{

constexpr std::size_t roundUp(std::size_t value, std::size_t step)
{
	return (value + step - 1) / step * step;
}

// The device memory of one running cut. It is kept from cut to cut. A generation allocates only if its front is larger
// than all fronts before it.
struct ClassifyWorkspace
{
	explicit ClassifyWorkspace(gpu::Device& device) : timers(device, "GPU cut") {}

	// Made by the first slice.
	Status prepare(gpu::Device& device, const gpu::Pipeline& pipeline);
	// Room for so many cells of a generation, over all sheets. What is in the buffers is lost.
	Status reserveFront(gpu::Device& device, std::size_t cells);
	// Room for what stays the same during a slice.
	Status reserveSheets(gpu::Device& device, std::size_t bytes);
	Status reserveAxes(gpu::Device& device, std::size_t texels);

	// Waits for the submitted work, and gives each run its codes: run.count codes from run.offset on, for the cells
	// from run.begin on in run.front.
	template <class Run>
	Status takeCodes(const std::vector<Run>& runs)
	{
		if (Status done = commands.wait(); !done)
			return done;
		codes.invalidate();
		const auto* from = codes.mappedAs<std::uint32_t>();
		for (const Run& run : runs)
			std::memcpy(run.front->codes.data() + run.begin, from + run.offset, run.count * sizeof(std::uint32_t));
		return Nothing{};
	}

	gpu::Commands commands;
	gpu::DescriptorSets sets; // set i serves dispatch i of a generation
	gpu::Timers timers;
	gpu::Buffer front;  // cell ids, written by the host
	gpu::Buffer codes;  // read by the host
	gpu::Buffer sheets; // ClassifyPlane each, at offsets that the device can bind
	gpu::ShaderArray axes;
};

} // namespace vp::classify
