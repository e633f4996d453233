#pragma once

#include "base/ids.h"
#include "base/raw_vector.h"
#include "cases/lattice_cases.h"
#include "grid/block.h"
#include "grid/structured.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>

namespace vp::find
{

// Numbers of vertices, polygons and corners that cut cells of a lattice add to a mesh. Cells whose faces are walked do
// not count.
struct SpanCounts
{
	std::uint32_t vertices = 0;
	std::uint32_t polygons = 0;
	std::uint32_t corners = 0; // corners of the polygons

	SpanCounts& operator+=(const SpanCounts& more)
	{
		vertices += more.vertices;
		polygons += more.polygons;
		corners += more.corners;
		return *this;
	}
};

struct SpanCells
{
	std::size_t looked_at = 0;
	std::size_t cut = 0;    // those that are cut and not left out
	std::size_t walked = 0; // cut cells whose case has no entry in the table

	SpanCells& operator+=(const SpanCells& more)
	{
		looked_at += more.looked_at;
		cut += more.cut;
		walked += more.walked;
		return *this;
	}
};

// A run of cut cells [begin, end) along i, bounded by columns of four points that agree or by the grid's sides. Its row
// is that of its lowest points, k * points_j + j; its end - begin + 1 columns tell its cells' cases, and which of them
// are left out.
//
// Rows of the last j or k hold no cells. Spans there stand beside those of the cells before them, with columns of their
// own: for the edges that the points of the row own.
struct Span
{
	std::uint32_t row;
	std::uint32_t begin;
	std::uint32_t end;
	std::uint32_t columns; // index of its first column in SpanCut::columns
	SpanCounts counts;     // its own; in a SpanCut, those of the spans before it
};

// The cut cells of a sheet in a structured block.
struct SpanCut
{
	RawVector<Span> spans; // ascending by row, then begin
	RawVector<cases::ColumnCase> columns;
	SpanCounts counts; // total
	SpanCells cells;
	bool classified_at_once = false; // by a device too, as one front
};

// Calls visit(CellId) for every cut cell, in the order of the spans.
template <class Visit>
void forEachCutCell(const grid::Lattice& lattice, const SpanCut& cut, Visit&& visit)
{
	const std::uint32_t points_j = lattice.points()[1];
	const std::uint32_t points_k = lattice.points()[2];
	for (const Span& span : cut.spans)
	{
		const std::uint32_t k = span.row / points_j;
		const std::uint32_t j = span.row - k * points_j;
		if (j + 1 == points_j || k + 1 == points_k)
			continue;
		const cases::ColumnCase* columns = &cut.columns[span.columns];
		for (std::uint32_t i = span.begin; i < span.end; ++i)
			if (!(columns[i - span.begin] & cases::kLeftOut))
				visit(lattice.cell(i, j, k));
	}
}

// The same in a block, whose grid is a lattice.
template <class Visit>
void forEachCutCell(const grid::Block& block, const SpanCut& cut, Visit&& visit)
{
	std::visit(
	    [&](const auto& grid)
	    {
		    if constexpr (std::is_base_of_v<grid::Lattice, std::decay_t<decltype(grid)>>)
			    forEachCutCell(static_cast<const grid::Lattice&>(grid), cut, visit);
	    },
	    block.grid);
}

} // namespace vp::find
