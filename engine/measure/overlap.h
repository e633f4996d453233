#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "probe/transform.h"

#include <cstdint>
#include <utility>

namespace vp::measure
{

/// Where several inputs lie over each other, all figures of a sheet count them all.
struct Overlap
{
	double area = 0.0;                                // where polygons of two inputs lie over each other
	double share = 0.0;                               // the share of the area of all polygons
	std::pair<std::uint32_t, std::uint32_t> inputs{}; // the two that overlap the most, if the area is above 0
	bool operator==(const Overlap&) const = default;
};

/// Returns the area in which polygons of different inputs (grid::Block::input) lie over each other, for each two of
/// them: 3 inputs in one place count 3 times. Blocks of one input may overlap as they like, as levels of refinement and
/// overset grids do. Boundary faces in the plane do not count, so inputs that touch do not overlap. The time is that of
/// the polygons where the inputs' bounds meet.
///
/// mesh: of a plane sheet. frame: that of its content.
Overlap overlapOf(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const probe::Frame& frame);

} // namespace vp::measure
