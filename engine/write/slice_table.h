#pragma once

#include "base/raw_vector.h"
#include "base/vec.h"
#include "grid/block.h"
#include "grid/field.h"
#include "mesh/sheet_mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vp::write
{

// The values of one array at the vertices or on the polygons of a slice.
struct Column
{
	std::string name;
	int components = 1;
	grid::NumberType type = grid::NumberType::float64;
	std::vector<std::byte> bytes; // tuples x components numbers

	std::string componentName(int component) const; // name, name_x, name_0 …
	double value(std::size_t tuple, int component) const;
};

// The sheets of a slice as one set of polygons, with all arrays: what the file formats have in common.
struct SliceTable
{
	std::vector<Vec3> positions;
	RawVector<std::int64_t> polygon_starts; // polygons + 1 offsets into polygon_vertices
	RawVector<std::int64_t> polygon_vertices;
	// Per polygon: where it comes from.
	RawVector<std::int64_t> cell; // source id
	RawVector<std::int32_t> block;
	RawVector<std::int32_t> sheet;
	std::vector<double> contour; // the value of its contour, NaN of a sheet's own polygons; empty without contours
	bool has_contours = false;   // also without polygons
	std::vector<Column> vertex_columns;
	std::vector<Column> polygon_columns;

	std::size_t vertices() const { return positions.size(); }
	std::size_t polygons() const { return cell.size(); }
};

// Polygons of an iso surface grown from a sheet (contour/), beside the sheet's own.
struct ContourPiece
{
	const mesh::SheetMesh* mesh;
	std::int32_t sheet;
	double value;
};

// An array is identified by its name and association. If blocks hold it in different types, it is float64, and as wide
// as the widest. Interpolated values are float32 for sources that fit (float32, integers of up to 16 bits), else
// float64. A categorical array is not interpolated and keeps its type. meshes[i] is sheet first_sheet + i; contours
// follow behind them all. A polygon with holes becomes several of the same cell (mesh/part_holes.h).
SliceTable tabulate(const grid::BlockSet& blocks, std::span<const mesh::SheetMesh> meshes, std::size_t first_sheet = 0,
                    std::span<const ContourPiece> contours = {});

// Adds the column of contours to a table of sheets.
void addContourColumn(SliceTable& table);

// Puts the polygons of another table behind those of `table`. Both have the same columns.
void append(SliceTable&& other, SliceTable& table);

// Parts of a table of one mesh, for which it is empty yet. Arrays over cells need the cells.
void tabulatePolygons(const mesh::SheetMesh& mesh, SliceTable& table);
void tabulateCells(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, SliceTable& table);
void tabulateArrays(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, SliceTable& table);

} // namespace vp::write
