#pragma once

#include "find/span_cut.h"
#include "mesh/fan_sense.h"
#include "mesh/span_tables.h"

#include <algorithm>
#include <cstddef>

namespace vp::mesh
{

// Writes the polygons of the cells of runs to their places in a mesh, one after the other. For one thread.
class SpanPolygonWriter
{
public:
	using Sense = FanSense<cases::kMaxLatticeEdges>;
	struct Source
	{
		const find::SpanCut& cut;
		const OwnedVertices* owned; // per column
		std::uint32_t block;
		std::uint32_t first_polygon; // the cut's first polygon in the mesh
		std::uint32_t first_corner;
	};

	// end: one past the last span to come.
	SpanPolygonWriter(const Source& source, const Sense& sense, std::size_t end, SheetMesh& mesh)
	    : source_(source), sense_(sense), mesh_(mesh), last_corner_(firstCornerOf(end))
	{
	}

	// The span's first cell.
	void startSpan(std::size_t span, CellId cell)
	{
		const find::Span& begun = source_.cut.spans[span];
		columns_ = &source_.cut.columns[begun.columns];
		cell_ = cell;
		polygon_ = source_.first_polygon + begun.counts.polygons;
		corner_ = firstCornerOf(span);
		// Numbers written behind a polygon belong to the next one, if that is this thread's.
		has_room_ = firstCornerOf(span + 1) + cases::kMaxLatticeEdges <= last_corner_;
	}

	// The span's next cells. rows: where the vertices of the four rows of points stand among those owned. A row that
	// has none may stand anywhere.
	void add(std::uint32_t count, const std::ptrdiff_t (&rows)[4])
	{
		if (has_room_)
			add<true>(count, rows);
		else
			add<false>(count, rows);
	}

	bool hasSlivers() const { return slivers_; }

private:
	template <bool kHasRoom>
	void add(std::uint32_t count, const std::ptrdiff_t (&rows)[4])
	{
		const Sense sense = sense_;
		const CornerPlaces* table = tables_[turned_];
		const std::uint32_t* column = source_.owned[0].along;
		std::uint32_t* corners = mesh_.polygon_vertices.data() + corner_;
		std::uint32_t* starts = mesh_.polygon_starts.data() + polygon_;
		BlockCell* cells = mesh_.polygon_cells.data() + polygon_;
		std::uint32_t corner = corner_;
		BlockCell cell{source_.block, cell_};
		for (const cases::ColumnCase *at = columns_, *end = at + count; at != end; ++at, ++cell.cell, column += 4)
		{
			const CornerPlaces& places = table[*at];
			if (!places.corners)
				continue;
			// All places are read and written, however many corners there are: that cannot be foreseen.
			std::uint32_t spare[cases::kMaxLatticeEdges];
			std::uint32_t* to = kHasRoom ? corners : spare;
			for (int e = 0; e < cases::kMaxLatticeEdges; ++e)
				to[e] = column[rows[places.row[e]] + places.number[e]];
			const double area = sense.areaOf(to);
			if (!sense.isClear(area))
				table = checkSense(sense.checked(area, to), to, places.corners);
			if (!kHasRoom)
				std::copy_n(to, places.corners, corners);
			*cells++ = cell;
			corners += places.corners;
			corner += places.corners;
			*++starts = corner;
		}
		columns_ += count;
		cell_ = cell.cell;
		corner_ = corner;
		polygon_ = static_cast<std::uint32_t>(cells - mesh_.polygon_cells.data());
	}

	// Turns a polygon that does not run counter-clockwise. Returns the table for the next one.
	const CornerPlaces* checkSense(double area, std::uint32_t* polygon, unsigned corners)
	{
		slivers_ |= area == 0.0;
		if (area < 0.0 || (turned_ && !(area > 0.0)))
			std::reverse(polygon, polygon + corners);
		turned_ ^= area < 0.0;
		return tables_[turned_];
	}

	std::uint32_t firstCornerOf(std::size_t span) const
	{
		const find::SpanCut& cut = source_.cut;
		return source_.first_corner + (span < cut.spans.size() ? cut.spans[span].counts.corners : cut.counts.corners);
	}

	const Source source_;
	const Sense sense_;
	SheetMesh& mesh_;
	const std::array<const CornerPlaces*, 2> tables_{cornerTable(false).data(), cornerTable(true).data()};
	std::uint32_t last_corner_;
	bool has_room_ = false;
	const cases::ColumnCase* columns_ = nullptr; // column cases from the next cell on
	CellId cell_ = 0;                            // the next cell
	std::uint32_t polygon_ = 0;                  // the next polygon
	std::uint32_t corner_ = 0;                   // its first corner
	// Nearly all polygons of a grid run the same way. They are read in the order that suited the one before.
	bool turned_ = false;
	bool slivers_ = false;
};

} // namespace vp::mesh
