#include "write/particle_file.h"

#include "grid/link/for_ranges.h"
#include "write/place_values.h"
#include "write/poly_data.h"
#include "write/set_arrays.h"

#include <limits>

namespace vp::write
{

namespace
{

using grid::NumberType;
using vectors::Traces;

// Traces of several sheets in one, as the file has them.
struct LineTable
{
	std::vector<Vec3> places;
	std::vector<double> times;
	std::vector<Vec3> vectors;
	std::vector<std::int32_t> block;
	std::vector<std::int64_t> cell; // source id, -1 outside
	std::vector<Column> columns;
	// VTK knows no line of one point, and numbers single points before lines.
	std::vector<std::int64_t> dot_starts{0};
	std::vector<std::int64_t> dots;
	std::vector<std::int64_t> line_starts{0};
	std::vector<std::int64_t> lines;
	// Per dot, then per line.
	std::vector<std::int32_t> sheet;
	std::vector<std::int64_t> seed;
	std::vector<std::int32_t> begin;
	std::vector<std::int32_t> end;
};

// Returns true if this process has the block's cells. Each process has only the cells of its own blocks.
bool isHere(const grid::Block& block)
{
	return std::visit([](const auto& grid) { return grid.cellCount() > 0; }, block.grid);
}

void fillColumns(const grid::BlockSet& blocks, const Traces& traces, std::span<const SetArray> arrays,
                 std::vector<Column>& columns)
{
	constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
	grid::forRanges(traces.points.size(),
	                [&](std::size_t i)
	                {
		                thread_local locate::CellWeights weights;
		                const std::uint32_t b = traces.blocks[i];
		                const bool inside = traces.cells[i] != kNoCell && isHere(blocks.blocks[b]);
		                if (inside)
			                locate::weighCell(blocks.blocks[b], traces.cells[i], traces.points[i], weights);
		                for (std::size_t a = 0; a < arrays.size(); ++a)
		                {
			                Column& column = columns[a];
			                const grid::Field* field = arrays[a].per_block[b];
			                for (int c = 0; c < column.components; ++c)
			                {
				                const bool known = inside && !weights.points.empty() && field && c < field->components;
				                const double value = known ? std::visit([&](const auto& grid)
				                                                        { return valueAt(grid, *field, c, weights); },
				                                                        blocks.blocks[b].grid)
				                                           : kNan;
				                const std::size_t number = i * static_cast<std::size_t>(column.components) + c;
				                grid::storeNumber(column.type, value,
				                                  &column.bytes[number * grid::byteSize(column.type)]);
			                }
		                }
	                });
}

std::int64_t sourceCellOf(const grid::BlockSet& blocks, std::uint32_t block, CellId cell)
{
	if (cell == kNoCell || !isHere(blocks.blocks[block]))
		return -1;
	return grid::cellNumber(blocks.blocks[block], cell);
}

void addPoints(const Traces& traces, const TraceColumns& columns, LineTable& table)
{
	const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
	append(table.places, traces.points);
	append(table.times, traces.times);
	append(table.vectors, traces.vectors);
	append(table.block, columns.block);
	append(table.cell, columns.cell);
	if (table.columns.empty())
		table.columns = columns.arrays;
	else
		for (std::size_t a = 0; a < columns.arrays.size(); ++a)
			append(table.columns[a].bytes, columns.arrays[a].bytes);
}

// Adds the traces of one sheet: either those of one point (dots), or the others. The sheet's points begin at `first` in
// the table.
void addTraces(const Traces& traces, std::int32_t sheet, std::size_t first, bool dots, LineTable& table)
{
	std::vector<std::int64_t>& ids = dots ? table.dots : table.lines;
	std::vector<std::int64_t>& starts = dots ? table.dot_starts : table.line_starts;
	for (std::size_t t = 0; t < traces.count(); ++t)
	{
		if ((traces.size(t) == 1) != dots)
			continue;
		for (std::size_t i = 0; i < traces.size(t); ++i)
			ids.push_back(static_cast<std::int64_t>(first + traces.first(t) + i));
		starts.push_back(static_cast<std::int64_t>(ids.size()));
		table.sheet.push_back(sheet);
		table.seed.push_back(traces.seeds[t]);
		table.begin.push_back(static_cast<std::int32_t>(traces.begins[t]));
		table.end.push_back(static_cast<std::int32_t>(traces.ends[t]));
	}
}

void addAllTraces(std::span<const Traces> traces, LineTable& table)
{
	for (const bool dots : {true, false})
	{
		std::size_t first = 0;
		for (std::size_t s = 0; s < traces.size(); ++s)
		{
			addTraces(traces[s], static_cast<std::int32_t>(s), first, dots, table);
			first += traces[s].points.size();
		}
	}
}

LineTable tabulate(std::span<const Traces> traces, std::span<const TraceColumns> columns)
{
	LineTable table;
	for (std::size_t s = 0; s < traces.size(); ++s)
		addPoints(traces[s], columns[s], table);
	addAllTraces(traces, table);
	return table;
}

} // namespace

TraceColumns traceColumns(const grid::BlockSet& blocks, const Traces& traces)
{
	const std::vector<SetArray> arrays = arraysOf(blocks, grid::Association::point);
	TraceColumns columns;
	for (const SetArray& array : arrays)
	{
		Column& column = columns.arrays.emplace_back();
		column.name = array.name;
		column.components = array.components;
		column.type = interpolatedType(array);
		column.bytes.resize(traces.points.size() * static_cast<std::size_t>(array.components) *
		                    grid::byteSize(column.type));
	}
	fillColumns(blocks, traces, arrays, columns.arrays);
	for (std::size_t i = 0; i < traces.points.size(); ++i)
	{
		columns.block.push_back(static_cast<std::int32_t>(traces.blocks[i]));
		columns.cell.push_back(sourceCellOf(blocks, traces.blocks[i], traces.cells[i]));
	}
	return columns;
}

Status writeTraces(const grid::BlockSet& blocks, std::span<const Traces> traces, const std::string& path)
{
	std::vector<TraceColumns> columns;
	for (const Traces& sheet : traces)
		columns.push_back(traceColumns(blocks, sheet));
	return writeTraces(traces, columns, path);
}

Status writeTraces(std::span<const Traces> traces, std::span<const TraceColumns> columns, const std::string& path)
{
	Result<AtomicFile> file = AtomicFile::create(path);
	if (!file)
		return file.error();
	const LineTable table = tabulate(traces, columns);
	const std::string ends = joinTexts(vectors::kTraceEndWords);
	PolyData data;
	data.points = table.places;
	data.dots = {table.dot_starts, table.dots};
	data.lines = {table.line_starts, table.lines};
	data.point_arrays.add(table.columns);
	data.point_arrays.add(xmlArray("vprobe:time", NumberType::float64, 1, table.times));
	data.point_arrays.add(xmlArray("vprobe:vector", NumberType::float64, 3, table.vectors));
	data.point_arrays.add(xmlArray("vprobe:block", NumberType::int32, 1, table.block));
	data.point_arrays.add(xmlArray("vprobe:cell", NumberType::int64, 1, table.cell));
	data.cell_arrays.add(xmlArray("vprobe:sheet", NumberType::int32, 1, table.sheet));
	data.cell_arrays.add(xmlArray("vprobe:seed", NumberType::int64, 1, table.seed));
	data.cell_arrays.add(xmlArray("vprobe:begin", NumberType::int32, 1, table.begin));
	data.cell_arrays.add(xmlArray("vprobe:end", NumberType::int32, 1, table.end));
	data.file_arrays.add(xmlTexts("vprobe:ends", ends));
	writePolyData(data, *file);
	return file->commit();
}

} // namespace vp::write
