#pragma once

#include "traverse/bfs.h"

#include <span>

namespace vp::slice
{

// Classifies in double precision on the calling thread: the oracle that the GPU is held against.
template <class Surface, class Window = seed::SheetWindow>
class CpuClassifier
{
public:
	// The lanes stay the caller's, and are those that are traversed.
	explicit CpuClassifier(std::span<const traverse::Lane<Surface, Window>> lanes) : lanes_(lanes) {}

	Status classify(std::span<const traverse::FrontSlice> fronts)
	{
		for (const traverse::FrontSlice& front : fronts)
			std::visit([&](const auto& grid) { classifyFront(grid, lanes_[front.lane].surface, front); },
			           lanes_[front.lane].block->grid);
		return Nothing{};
	}

private:
	template <class G>
	static void classifyFront(const G& grid, const Surface& surface, const traverse::FrontSlice& front)
	{
		for (std::size_t i = 0; i < front.cells.size(); ++i)
		{
			const CellId cell = front.cells[i];
			const grid::CellShape shape = grid.shape(cell);
			front.words[i] = shape == grid::CellShape::polyhedron
			                     ? shared::kWordWalk
			                     : traverse::classifyByTable(grid, surface, cell, shape);
		}
	}

	std::span<const traverse::Lane<Surface, Window>> lanes_;
};

} // namespace vp::slice
