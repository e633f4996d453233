#pragma once

#include "base/parallel_for.h"
#include "find/generations.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <array>
#include <span>

namespace vp::classify
{

// Classifies in double precision: the oracle that the GPU is held against. Planes are classified on the calling thread,
// since the CPU finds their cells in other ways. Other surfaces are classified on all cores.
template <class Surface, class Window = seed::SheetWindow>
class CpuClassifier
{
public:
	// The sheets stay the caller's, and are those that are traversed.
	explicit CpuClassifier(std::span<const find::SheetInBlock<Surface, Window>> sheets) : sheets_(sheets) {}

	Status classify(std::span<const find::Front> fronts)
	{
		for (const find::Front& front : fronts)
			std::visit([&](const auto& grid) { classifyFront(grid, sheets_[front.sheet].surface, front); },
			           sheets_[front.sheet].block->grid);
		return Nothing{};
	}

private:
	template <class G>
	static void classifyFront(const G& grid, const Surface& surface, const find::Front& front)
	{
		if constexpr (surface::kIsCurved<Surface>)
		{
			constexpr std::size_t kCells = Surface::kMaxPoints / grid::kMaxShapePoints;
			constexpr std::size_t kGrain = 64; // times kCells
			const auto classifyPart = [&](const tbb::blocked_range<std::size_t>& part)
			{
				for (std::size_t i = part.begin(); i < part.end(); ++i)
				{
					const std::size_t begin = i * kCells;
					const std::size_t count = std::min(kCells, front.cells.size() - begin);
					classifyTogether(grid, surface, front.cells.subspan(begin, count),
					                 front.codes.subspan(begin, count));
				}
			};
			tracedFor(tbb::blocked_range<std::size_t>(0, (front.cells.size() + kCells - 1) / kCells, kGrain),
			          classifyPart);
		}
		else
			for (std::size_t i = 0; i < front.cells.size(); ++i)
			{
				const CellId cell = front.cells[i];
				const grid::CellShape shape = grid.shape(cell);
				front.codes[i] = shape == grid::CellShape::polyhedron
				                     ? shared::kCodeWalk
				                     : find::classifyByTable(grid, surface, cell, shape);
			}
	}

	// A few cells: what a surface computes is computed for all their points at once, which pays for an expression.
	template <class G>
	static void classifyTogether(const G& grid, const Surface& surface, std::span<const CellId> cells,
	                             std::span<std::uint32_t> codes)
	{
		std::array<PointId, Surface::kMaxPoints> points;
		std::array<double, Surface::kMaxPoints> heights;
		std::size_t count = 0;
		for (const CellId cell : cells)
			if (grid.shape(cell) != grid::CellShape::polyhedron)
				for (const PointId p : grid.cellPoints(cell))
					points[count++] = p;
		surface.heights(grid, std::span(points).first(count), heights.data());
		const double* next = heights.data();
		for (std::size_t i = 0; i < cells.size(); ++i)
		{
			const grid::CellShape shape = grid.shape(cells[i]);
			codes[i] = shared::kCodeWalk;
			if (shape == grid::CellShape::polyhedron)
				continue;
			const int vertices = grid.cellPoints(cells[i]).size;
			codes[i] = find::caseCodes(shape)[caseIndex(next, vertices)];
			next += vertices;
		}
	}

	static std::uint32_t caseIndex(const double* heights, int vertices)
	{
		std::uint32_t index = 0;
		for (int v = 0; v < vertices; ++v)
			index |= static_cast<std::uint32_t>(heights[v] >= 0.0) << v;
		return index;
	}

	std::span<const find::SheetInBlock<Surface, Window>> sheets_;
};

} // namespace vp::classify
