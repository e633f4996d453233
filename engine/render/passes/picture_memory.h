#pragma once

#include "base/result.h"
#include "render/passes/picture_part.h"
#include "render/scene/scene.h"

#include <cstdint>
#include <string>

namespace vp::gpu
{
class Device;
}

namespace vp::render
{

// How a picture is drawn within the device's memory budget (Device::memoryBudget): as a whole, or in parts that are
// drawn one after the other with the same images.
struct PicturePlan
{
	PicturePart first;        // its extent is that of all parts
	std::uint32_t margin = 0; // rows of a part that the part beside it shows, since colors depend on neighbors

	std::uint32_t count() const;
	std::uint32_t firstRow(std::uint32_t part) const;
	VkRect2D shown(std::uint32_t part) const; // the pixels of the picture that a part gives
};

// fragment_bytes: the limit of the lists of surface fragments. An error that names what takes the memory where not even
// a few rows fit.
Result<PicturePlan> planPicture(const gpu::Device& device, const Scene& scene, std::uint64_t fragment_bytes);

// One line that tells in how many parts the picture is drawn, and what takes the memory.
std::string describe(const PicturePlan& plan, const gpu::Device& device, const Scene& scene);

} // namespace vp::render
