#pragma once

#include "cases/case_table.h"
#include "classify/gpu_blocks.h"
#include "classify/gpu_records.h"
#include "gpu/shader.h"
#include "shared/classify_types.h"
#include "shared/surface_types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <type_traits>

namespace vp::classify
{

/// A place along an axis of a grid with straight axes, as the shaders read it.
using AxisTexel = std::array<std::uint32_t, 4>;

/// A sheet in a block, as the device classifies it.
struct GpuSheetInBlock
{
	std::size_t block = 0;
	std::shared_ptr<const gpu::Pipeline> pipeline; // null: the CPU classifies its cells
	gpu::ShaderArray::Place values;                // values of the shown array; null: there are none
	std::shared_ptr<const void> keeps;             // keeps the memory of `values` alive
	std::shared_ptr<SheetRecords> records;         // gets the polygons; null: only the codes come back
	/// Writes what the shader is told, kMaxTold bytes at most, to `told`, and axisTexels() texels to `axes`, of which
	/// the first is texel `axis_start` of their buffer.
	std::function<void(std::size_t axis_start, std::span<AxisTexel> axes, std::byte* told)> describe;

	static constexpr std::size_t kMaxTold = std::max(sizeof(shared::ClassifyPlane), sizeof(shared::ClassifySurface));
};

/// The texels that the axes of an image or rectilinear grid take; 0 for other grids.
std::size_t axisTexels(const grid::AnyGrid& grid);

/// How cells find their points and cases; for what has these fields of ClassifyPlane.
template <class Told>
void describeCells(const grid::AnyGrid& any, std::size_t axis_start, Told& to)
{
	const auto describeLattice = [&](const auto& grid)
	{
		if constexpr (std::is_base_of_v<grid::Lattice, std::decay_t<decltype(grid)>>)
		{
			to.cells_i = grid.cells()[0];
			to.cells_j = grid.cells()[1];
			to.inverse_i = grid.cells()[0] ? 0xFFFFFFFFu / grid.cells()[0] : 0;
			to.inverse_j = grid.cells()[1] ? 0xFFFFFFFFu / grid.cells()[1] : 0;
			to.points_i = grid.points()[0];
			to.points_layer = grid.points()[0] * grid.points()[1];
			to.axis_start[0] = static_cast<std::uint32_t>(axis_start);
			to.axis_start[1] = to.axis_start[0] + grid.points()[0];
			to.axis_start[2] = to.axis_start[1] + grid.points()[1];
		}
	};
	std::visit(describeLattice, any);
	for (int shape = 0; shape < grid::kTableShapes; ++shape)
		to.table_start[shape] = cases::caseTableStart(static_cast<grid::CellShape>(shape));
}

/// Returns a float that is not less than the value, so an upper bound stays one.
float boundedAbove(double value);

} // namespace vp::classify
