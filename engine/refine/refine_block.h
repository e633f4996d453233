#pragma once

#include "grid/curved/curved_cells.h"
#include "grid/field.h"
#include "refine/cell_boxes.h"
#include "refine/cell_kinds.h"
#include "refine/part_list.h"
#include "refine/sheets.h"
#include "refine/unfinished.h"

#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

namespace vp::refine
{

/// An array that is shown, and what its values may be off.
struct ShownArray
{
	const grid::Field* field;
	int component;  // or grid::kMagnitude
	double allowed; // above 0

	int width() const { return component == grid::kMagnitude ? field->components : 1; }
};

/// The most numbers of a point that a tolerance applies to.
inline constexpr int kMaxShownNumbers = 9;

struct BlockParts
{
	PartList parts;
	std::size_t looked_at = 0;
	std::size_t cells = 0;
	Unfinished unfinished{};
};

/// Refines the cells of a block that the sheets meet, on all cores; the result is the same for any number of them.
/// max_parts: of all of its cells. Throws TooManyParts where there are more than kMaxParts before any is refined. On a
/// stop request it returns what it has.
BlockParts refineBlock(const grid::CurvedCells& curved, const CellKinds& kinds, const CellBoxes& boxes,
                       const Sheets& sheets, std::span<const ShownArray> shown, std::size_t max_parts,
                       const std::stop_token& stop);

/// Returns a point array at the points of the parts: by the shape functions of the cells. Integers are rounded, and
/// stay between those of the cell's nodes.
grid::Field fieldOfParts(const grid::CurvedCells& curved, const CellKinds& kinds, const PartList& parts,
                         const grid::Field& field);

} // namespace vp::refine
