#pragma once

#include "base/ids.h"

#include <functional>

namespace vp::grid
{

/// Returns true if a cell may be part of a cut. An empty function admits every cell.
using CellFilter = std::function<bool(CellId)>;

/// Returns a filter for the cells that pass both.
inline CellFilter both(CellFilter a, CellFilter b)
{
	if (!a || !b)
		return a ? a : b;
	return [a = std::move(a), b = std::move(b)](CellId cell) { return a(cell) && b(cell); };
}

} // namespace vp::grid
