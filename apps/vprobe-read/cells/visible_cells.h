#pragma once

#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json.hpp>

#include <array>
#include <vector>

class vtkDataSet;

namespace vp::reader::cells
{

// The bits of vtkGhostType on cells that mean "not to be shown": duplicate, refined, hidden.
extern const unsigned char kHiddenCellBits;

// Returns one mark per cell of a lattice. It is not zero if the cell is hidden: by its own ghost mark, or because a
// point of it is blanked. The list is empty if nothing is hidden.
std::vector<unsigned char> hiddenCellsOf(vtkDataSet* lattice, const std::array<int, 3>& points);

// Describes a lattice with hidden cells as an unstructured block: its points, a hexahedron per visible cell, and an
// empty cell per hidden one, so that point and cell arrays keep their numbering.
nlohmann::json describeVisible(arrays::Writer& writer, vtkDataSet* lattice, const std::array<int, 3>& points,
                               const std::vector<unsigned char>& hidden);

} // namespace vp::reader::cells
