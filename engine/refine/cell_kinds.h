#pragma once

#include "grid/curved/curved_cells.h"
#include "refine/cell_kind.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace vp::refine
{

/// The kinds of a block's cells.
class CellKinds
{
public:
	/// Looks at the types of all cells. The cells must outlive it.
	explicit CellKinds(const grid::CurvedCells& curved);

	/// Returns true if quadratic tetrahedra are the only curved cells, for which there is a faster way.
	bool areQuadraticTetrahedra() const { return only_quadratic_; }
	/// Returns the kind of a cell that has an inside.
	const CellKind& of(std::size_t cell) const { return *kinds_[numberOf(cell)]; }
	std::size_t bytes() const { return 2 * numbers_.capacity(); }

private:
	std::uint16_t numberOf(std::size_t cell) const
	{
		return numbers_.empty() ? by_type_[curved_.cells.types[cell]] : numbers_[cell];
	}

	const grid::CurvedCells& curved_;
	bool only_quadratic_ = true;
	std::vector<std::unique_ptr<CellKind>> kinds_;
	std::array<std::uint16_t, 256> by_type_{};
	std::vector<std::uint16_t> numbers_; // per cell: its kind, if the type alone does not tell
};

} // namespace vp::refine
