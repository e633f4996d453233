#pragma once

#include "cases/case_table.h"
#include "classify/gpu_blocks.h"
#include "probe/sheet.h"
#include "shared/classify_types.h"

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

namespace vp::classify
{

// What a lane of the traversal is: a sheet in a block.
struct GpuLane
{
	std::uint32_t sheet;
	std::uint32_t block;
};

using AxisTexel = std::array<std::uint32_t, 4>;

// The texels that the axes of an image or rectilinear grid take; 0 for other grids.
std::size_t axisTexels(const grid::AnyGrid& grid);

// What the shader is told about a sheet in a block. Fills `axes` (axisTexels() of them), whose first is texel
// `axis_start` of the buffer.
shared::ClassifyLane describeLane(const grid::Block& block, const GpuBlock& on_device, const GpuValues& values,
                                  bool field_chosen, bool doubles, const probe::Sheet& sheet, std::size_t axis_start,
                                  std::span<AxisTexel> axes);

// How cells find their points and cases; for what has these fields of ClassifyLane.
template <class ShaderLane>
void describeCells(const grid::AnyGrid& any, std::size_t axis_start, ShaderLane& lane)
{
	const auto describeLattice = [&](const auto& grid)
	{
		if constexpr (std::is_base_of_v<grid::Lattice, std::decay_t<decltype(grid)>>)
		{
			lane.cells_i = grid.cells()[0];
			lane.cells_j = grid.cells()[1];
			lane.inverse_i = grid.cells()[0] ? 0xFFFFFFFFu / grid.cells()[0] : 0;
			lane.inverse_j = grid.cells()[1] ? 0xFFFFFFFFu / grid.cells()[1] : 0;
			lane.points_i = grid.points()[0];
			lane.points_layer = grid.points()[0] * grid.points()[1];
			lane.axis_start[0] = static_cast<std::uint32_t>(axis_start);
			lane.axis_start[1] = lane.axis_start[0] + grid.points()[0];
			lane.axis_start[2] = lane.axis_start[1] + grid.points()[1];
		}
	};
	std::visit(describeLattice, any);
	for (int shape = 0; shape < grid::kTableShapes; ++shape)
		lane.table_start[shape] = cases::caseTableStart(static_cast<grid::CellShape>(shape));
}

// What is not less as a float: a bound stays a bound.
float boundedAbove(double value);

} // namespace vp::classify
