#pragma once

#include "base/ids.h"

#include <functional>

namespace vp::grid
{

/// Whether a cell may be part of a cut; an empty function says that every cell may.
using CellFilter = std::function<bool(CellId)>;

/// Cells that pass both.
inline CellFilter both(CellFilter a, CellFilter b)
{
	if (!a || !b)
		return a ? a : b;
	return [a = std::move(a), b = std::move(b)](CellId cell) { return a(cell) && b(cell); };
}

} // namespace vp::grid
