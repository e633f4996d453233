#pragma once

#include "gpu/buffer.h"
#include "grid/block.h"
#include "slice/field_choice.h"

#include <memory>
#include <string>

namespace vp::slice
{

// How a block lies in device memory; see shared/classify_types.h for the formats.
struct GpuBlock
{
	std::uint32_t cells_kind = 0;  // kCellsAxes …
	std::uint32_t points_kind = 0; // kPointsFloat …
	gpu::Buffer points;
	gpu::TexelView point_texels;
	gpu::Buffer cells;
	gpu::TexelView cell_texels;
	// Of the points; for fixed-point numbers the centre and unit they count from.
	Box bounds;
	Vec3 centre{0.0};
	Vec3 unit{1.0};
};

// The shown array of a block in the block's own numbering, R32F, `components` texels a point or cell.
struct GpuValues
{
	std::uint32_t kind = 0; // kValuesNone …
	std::uint32_t components = 0;
	gpu::Buffer buffer;
	gpu::TexelView texels;
};

// What one array of texels may take.
struct GpuLimits
{
	std::uint64_t texels;
	std::uint64_t bytes;

	// Why an array does not fit the device, or nothing.
	std::string refuse(const gpu::Device& device, std::uint64_t texels_wanted, std::uint64_t bytes_wanted) const;
	std::string refuse(const gpu::Device& device, const grid::Block& block) const;
};

Result<std::unique_ptr<GpuBlock>> uploadBlock(gpu::Device& device, const grid::Block& block);
// Without values where the block lacks the array.
Result<GpuValues> uploadValues(gpu::Device& device, const GpuLimits& limits, const grid::Block& block,
                               const FieldChoice& choice);

struct GpuTexels
{
	gpu::Buffer buffer;
	gpu::TexelView view;
};
Result<GpuTexels> uploadCaseTables(gpu::Device& device);
// One texel, for a shader that reads none.
Result<GpuTexels> uploadNoValues(gpu::Device& device);

} // namespace vp::slice
