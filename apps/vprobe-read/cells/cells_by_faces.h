#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace vp::reader::cells
{

class GrownCells;

// Cells that a file describes by their faces. A face's normal, by the right-hand rule, points out of its first cell
// into its second one.
struct CellsByFaces
{
	std::span<const std::int64_t> starts;  // faces + 1 offsets into corners
	std::span<const std::int64_t> corners; // points
	std::span<const std::int64_t> first;   // the cell of each face; -1 where there is none
	std::span<const std::int64_t> second;  // the same; those of the last faces may be left out
	std::size_t cells = 0;
};

// Adds all cells, in their order. The numbers must be consistent. Throws a Refusal if a cell has fewer than four faces,
// or a face fewer than three corners.
void addCellsByFaces(GrownCells& grown, const CellsByFaces& mesh);

} // namespace vp::reader::cells
