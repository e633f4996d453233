#pragma once

#include "grid/cell_list.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace vp::read
{

/// Hexahedra, wedges and pyramids may have four distinct corners, as Ansys and LS-DYNA write tetrahedra. LS-DYNA's
/// order, n1 n2 n3 n4 n4 n4 n4 n4, has a face with all four, and that face could be bent either way. This brings the
/// corners of such cells into the order n1 n2 n3 n3 n4 n4 n4 n4, whose faces are those of the tetrahedron. Copies the
/// connectivity if there is such a cell. Precondition: checkCells().
void orderCollapsed(grid::CellList& cells);
/// The same for some of the cells, in place. ids: their connectivity.
void orderCollapsed(const grid::CellList& cells, std::size_t begin, std::size_t end, std::span<std::int32_t> ids);

} // namespace vp::read
