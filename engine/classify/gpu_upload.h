#pragma once

#include "gpu/shader_array.h"
#include "grid/block.h"
#include "grid/field_choice.h"

#include <cstdint>
#include <memory>
#include <string>

namespace vp::classify
{

// How a block lies in device memory; see shared/classify_types.h for the formats.
struct GpuBlock
{
	std::uint32_t cells_kind = 0;  // kCellsAxes …
	std::uint32_t points_kind = 0; // kPointsFloat …
	gpu::ShaderArray points;
	gpu::ShaderArray cells;
	// The bounds of the points. For fixed-point numbers also the center and the unit that they count from.
	Box bounds;
	Vec3 center{0.0};
	Vec3 unit{1.0};
};

// The shown array of a block in the block's own numbering.
struct GpuValues
{
	std::uint32_t kind = 0;         // kValuesNone …
	std::uint32_t tuple_texels = 0; // number of texels of a tuple, of four numbers each
	bool nearest = false;           // categorical
	gpu::ShaderArray array;
};

// The largest size of one array.
struct GpuLimits
{
	std::uint64_t elements; // number of elements of 16 bytes
	std::uint64_t bytes;
};

// Why a block with any of its arrays does not fit the device; empty where it does.
std::string whyNotOnDevice(const gpu::Device& device, const GpuLimits& limits, const grid::Block& block);

Result<std::unique_ptr<GpuBlock>> uploadBlock(gpu::Device& device, const grid::Block& block);
// None where the block lacks the array.
Result<GpuValues> uploadValues(gpu::Device& device, const grid::Block& block, const grid::FieldChoice& choice);
Result<gpu::ShaderArray> uploadCaseTables(gpu::Device& device);
// One number, for a shader that has no values to read.
Result<gpu::ShaderArray> uploadNoValues(gpu::Device& device);

} // namespace vp::classify
