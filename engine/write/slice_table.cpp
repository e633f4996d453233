#include "write/slice_table.h"

#include "base/parallel_for.h"
#include "grid/number_types.h"
#include "mesh/mesh_values.h"
#include "mesh/part_holes.h"
#include "write/set_arrays.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

namespace vp::write
{

namespace
{

using grid::Association;
using grid::NumberType;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool isFloat(NumberType type)
{
	return type == NumberType::float32 || type == NumberType::float64;
}

std::byte* put(std::byte* at, NumberType type, double value)
{
	grid::storeNumber(type, value, at);
	return at + grid::byteSize(type);
}

using Meshes = std::span<const mesh::SheetMesh* const>;

// One component of a mesh's vertices, as `Number`, where each has so many.
template <class Number>
void storeComponent(std::span<const double> values, int component, int components, std::byte* begin)
{
	tracedFor(tbb::blocked_range<std::size_t>(0, values.size(), 16384),
	          [&](const tbb::blocked_range<std::size_t>& some)
	          {
		          for (std::size_t v = some.begin(); v < some.end(); ++v)
			          grid::storeAs<Number>(values[v], begin + (v * static_cast<std::size_t>(components) + component) *
			                                                       sizeof(Number));
	          });
}

Column vertexColumn(const grid::BlockSet& blocks, Meshes meshes, const SetArray& source)
{
	Column column{source.name, source.components, interpolatedType(source), {}};
	const std::size_t tuple = source.components * grid::byteSize(column.type);
	std::size_t vertices = 0;
	for (const mesh::SheetMesh* mesh : meshes)
		vertices += mesh->positions.size();
	column.bytes.resize(vertices * tuple);
	std::byte* begin = column.bytes.data();
	for (const mesh::SheetMesh* mesh : meshes)
	{
		for (int c = 0; c < source.components; ++c)
		{
			const RawVector<double> values = mesh::vertexValues(blocks, *mesh, source.per_block, c);
			grid::withNumberType(column.type, [&](auto number)
			                     { storeComponent<decltype(number)>(values, c, source.components, begin); });
		}
		begin += mesh->positions.size() * tuple;
	}
	return column;
}

// The tuple of a cell in the arrays of its block. number: grid::cellNumber().
std::size_t tupleOf(const grid::Block& block, CellId cell, std::int64_t number)
{
	return block.whole ? std::visit([&](const auto& grid) { return std::size_t(grid.sourceCell(cell)); }, block.grid)
	                   : static_cast<std::size_t>(number);
}

Column polygonColumn(const grid::BlockSet& blocks, Meshes meshes, const SliceTable& table, const SetArray& source)
{
	Column column{source.name, source.components, source.type, {}};
	const std::size_t number = grid::byteSize(source.type);
	const std::size_t tuple = number * source.components;
	column.bytes.resize(table.polygons() * tuple); // zero: the value of an integer that is not known
	std::byte* at = column.bytes.data();
	std::size_t polygon = 0;
	for (const mesh::SheetMesh* mesh : meshes)
		for (const mesh::BlockCell& from : mesh->polygon_cells)
		{
			const grid::Field* field = source.per_block[from.block];
			const int known = field ? field->components : 0;
			const std::size_t cell = tupleOf(blocks.blocks[from.block], from.cell, table.cell[polygon++]);
			if (field && field->type == source.type)
				std::memcpy(at, field->tuple(cell), known * number);
			else
				for (int c = 0; c < known; ++c) // blocks differ in type, so the column is float64
					put(at + c * number, source.type, field->value(cell, c));
			if (isFloat(source.type))
				for (int c = known; c < source.components; ++c)
					put(at + c * number, source.type, kNan);
			at += tuple;
		}
	return column;
}

template <class Work>
void forPolygons(const mesh::SheetMesh& mesh, Work&& work)
{
	tracedFor(tbb::blocked_range<std::size_t>(0, mesh.polygons(), 4096),
	          [&](const tbb::blocked_range<std::size_t>& some)
	          {
		          for (std::size_t p = some.begin(); p < some.end(); ++p)
			          work(p);
	          });
}

// base: vertices before those of the mesh.
void addPolygons(const mesh::SheetMesh& mesh, std::int64_t base, SliceTable& table)
{
	const std::size_t polygons = mesh.polygons();
	if (table.polygon_starts.empty())
		table.polygon_starts.push_back(0);
	if (polygons == 0)
		return;
	const std::size_t first = table.polygon_starts.size();
	const std::size_t corners = table.polygon_vertices.size(); // before those of this mesh
	const std::size_t begin = mesh.polygon_starts[0];
	table.polygon_vertices.resize(corners + mesh.polygon_starts[polygons] - begin);
	table.polygon_starts.resize(first + polygons);
	forPolygons(mesh,
	            [&](std::size_t p)
	            {
		            std::size_t corner = corners + mesh.polygon_starts[p] - begin;
		            for (const std::uint32_t v : mesh.polygon(p))
			            table.polygon_vertices[corner++] = base + v;
		            table.polygon_starts[first + p] = static_cast<std::int64_t>(corner);
	            });
}

void addCells(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, SliceTable& table)
{
	const std::size_t first = table.polygons();
	table.cell.resize(first + mesh.polygons());
	table.block.resize(first + mesh.polygons());
	forPolygons(mesh,
	            [&](std::size_t p)
	            {
		            const mesh::BlockCell& from = mesh.polygon_cells[p];
		            table.cell[first + p] = grid::cellNumber(blocks.blocks[from.block], from.cell);
		            table.block[first + p] = static_cast<std::int32_t>(from.block);
	            });
}

void addMesh(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, std::int32_t sheet, SliceTable& table)
{
	addPolygons(mesh, static_cast<std::int64_t>(table.positions.size()), table);
	addCells(blocks, mesh, table);
	table.sheet.resize(table.polygons(), sheet);
	table.positions.insert(table.positions.end(), mesh.positions.begin(), mesh.positions.end());
}

void addArrays(const grid::BlockSet& blocks, Meshes meshes, SliceTable& table)
{
	for (const SetArray& source : arraysOf(blocks, Association::point))
		table.vertex_columns.push_back(vertexColumn(blocks, meshes, source));
	for (const SetArray& source : arraysOf(blocks, Association::cell))
		table.polygon_columns.push_back(polygonColumn(blocks, meshes, table, source));
}

} // namespace

std::string Column::componentName(int component) const
{
	return write::componentName(name, components, component);
}

double Column::value(std::size_t tuple, int component) const
{
	return grid::loadNumber(type, bytes.data() + (tuple * components + component) * grid::byteSize(type));
}

SliceTable tabulate(const grid::BlockSet& blocks, std::span<const mesh::SheetMesh> meshes, std::size_t first_sheet,
                    std::span<const ContourPiece> contours)
{
	SliceTable table;
	table.polygon_starts.push_back(0);
	std::vector<const mesh::SheetMesh*> all;
	std::deque<mesh::SheetMesh> parted;
	const auto withoutHoles = [&](const mesh::SheetMesh& mesh) -> const mesh::SheetMesh&
	{
		std::optional<mesh::SheetMesh> parts = mesh::partHoles(mesh);
		return parts ? parted.emplace_back(std::move(*parts)) : mesh;
	};
	const auto add = [&](const mesh::SheetMesh& mesh, std::int32_t sheet)
	{
		all.push_back(&withoutHoles(mesh));
		addMesh(blocks, *all.back(), sheet, table);
	};
	for (std::size_t m = 0; m < meshes.size(); ++m)
		add(meshes[m], static_cast<std::int32_t>(first_sheet + m));
	if (!contours.empty())
		addContourColumn(table);
	for (const ContourPiece& contour : contours)
	{
		add(*contour.mesh, contour.sheet);
		table.contour.resize(table.polygons(), contour.value);
	}
	addArrays(blocks, all, table);
	return table;
}

void addContourColumn(SliceTable& table)
{
	table.has_contours = true;
	table.contour.assign(table.polygons(), kNan);
}

void tabulatePolygons(const mesh::SheetMesh& mesh, SliceTable& table)
{
	addPolygons(mesh, 0, table);
}

void tabulateCells(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, SliceTable& table)
{
	addCells(blocks, mesh, table);
}

void tabulateArrays(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, SliceTable& table)
{
	const mesh::SheetMesh* const all = &mesh;
	addArrays(blocks, {&all, 1}, table);
}

namespace
{

template <class Numbers>
void appendAll(const Numbers& from, Numbers& to)
{
	const std::size_t before = to.size();
	to.resize(before + from.size());
	std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(before));
}

void appendColumns(const std::vector<Column>& from, std::vector<Column>& to)
{
	for (std::size_t c = 0; c < to.size(); ++c)
		appendAll(from[c].bytes, to[c].bytes);
}

} // namespace

void append(SliceTable&& other, SliceTable& table)
{
	const auto vertices = static_cast<std::int64_t>(table.vertices());
	const auto corners = static_cast<std::int64_t>(table.polygon_vertices.size());
	for (std::int64_t& vertex : other.polygon_vertices)
		vertex += vertices;
	if (table.polygon_starts.empty())
		table.polygon_starts.push_back(0);
	for (std::size_t p = 1; p < other.polygon_starts.size(); ++p)
		table.polygon_starts.push_back(other.polygon_starts[p] + corners);
	appendAll(other.positions, table.positions);
	appendAll(other.polygon_vertices, table.polygon_vertices);
	appendAll(other.cell, table.cell);
	appendAll(other.block, table.block);
	appendAll(other.sheet, table.sheet);
	appendAll(other.contour, table.contour);
	appendColumns(other.vertex_columns, table.vertex_columns);
	appendColumns(other.polygon_columns, table.polygon_columns);
}

} // namespace vp::write
