#include "ranks/write/joined_tables.h"

#include "ranks/data/share.h"
#include "ranks/particles/joined_traces.h"
#include "write/file_set.h"
#include "write/particle_file.h"
#include "write/slice_file.h"
#include "write/slice_parts.h"
#include "write/slice_sets.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace vp::ranks
{

namespace
{

template <class T>
void putNumbers(MessageWriter& to, const T& numbers)
{
	to.putAll(std::span(numbers.data(), numbers.size()));
}

template <class T>
void takeNumbers(MessageReader& from, T& numbers)
{
	const auto all = from.getAll<typename T::value_type>();
	numbers.resize(all.size());
	std::copy(all.begin(), all.end(), numbers.begin());
}

void putColumns(MessageWriter& to, const std::vector<write::Column>& columns)
{
	for (const write::Column& column : columns)
		to.putAll(column.bytes);
}

// Names and types are the same at all ranks, since each knows the arrays of all blocks.
Bytes messageOf(const write::SliceTable& table)
{
	MessageWriter message;
	putNumbers(message, table.positions);
	putNumbers(message, table.polygon_starts);
	putNumbers(message, table.polygon_vertices);
	putNumbers(message, table.cell);
	putNumbers(message, table.block);
	putNumbers(message, table.sheet);
	putNumbers(message, table.contour);
	putColumns(message, table.vertex_columns);
	putColumns(message, table.polygon_columns);
	return message.take();
}

write::SliceTable tableOf(const Bytes& bytes, const write::SliceTable& like)
{
	MessageReader reader(bytes);
	write::SliceTable table;
	table.has_contours = like.has_contours;
	takeNumbers(reader, table.positions);
	takeNumbers(reader, table.polygon_starts);
	takeNumbers(reader, table.polygon_vertices);
	takeNumbers(reader, table.cell);
	takeNumbers(reader, table.block);
	takeNumbers(reader, table.sheet);
	takeNumbers(reader, table.contour);
	for (const auto& [columns, like_columns] : {std::pair(&table.vertex_columns, &like.vertex_columns),
	                                            std::pair(&table.polygon_columns, &like.polygon_columns)})
		for (const write::Column& column : *like_columns)
			columns->push_back({column.name, column.components, column.type, reader.getAll<std::byte>()});
	return table;
}

// The table of a sheet with the rows of all ranks; at the first rank alone.
write::SliceTable gatheredRows(Team& team, write::SliceTable own)
{
	// Along the tree, tables come together in the order of ranks.
	Bytes bytes = messageOf(own);
	team.reduce(bytes,
	            [&](Bytes& into, const Bytes& other)
	            {
		            write::SliceTable table = tableOf(into, own);
		            write::append(tableOf(other, own), table);
		            into = messageOf(table);
	            });
	return tableOf(bytes, own);
}

// The polygons that this rank has of a sheet, or of one contour.
struct OwnTable
{
	write::SliceTable table;
	std::size_t sheet;
	bool is_contour;
};

// Sheets come first.
std::vector<OwnTable> ownTables(const Ranks& ranks, const grid::BlockSet& blocks,
                                std::span<const mesh::SheetMesh> sheets, std::span<const write::ContourPiece> contours)
{
	std::vector<OwnTable> tables;
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		tables.push_back({write::tabulate(blocks, sheets.subspan(s, 1), s), s, false});
		if (!contours.empty())
			write::addContourColumn(tables.back().table);
	}
	for (const write::ContourPiece& contour : contours)
		tables.push_back(
		    {write::tabulate(blocks, {}, 0, {&contour, 1}), static_cast<std::size_t>(contour.sheet), true});
	for (OwnTable& own : tables)
		nameWholeBlocks(ranks, own.table.block);
	return tables;
}

// The same of all ranks, at the first one.
std::vector<OwnTable> gatheredTables(const Ranks& ranks, const grid::BlockSet& blocks,
                                     std::span<const mesh::SheetMesh> sheets,
                                     std::span<const write::ContourPiece> contours)
{
	std::vector<OwnTable> tables = ownTables(ranks, blocks, sheets, contours);
	for (OwnTable& own : tables)
		own.table = gatheredRows(*ranks.team(), std::move(own.table));
	return tables;
}

// One behind the other: contours behind all sheets.
write::SliceTable joined(std::vector<OwnTable> tables)
{
	write::SliceTable all = std::move(tables.at(0).table);
	for (OwnTable& own : std::span(tables).subspan(1))
		write::append(std::exchange(own.table, {}), all);
	return all;
}

// One for each sheet, with its contours.
std::vector<write::SliceTable> sheetsWithContours(std::vector<OwnTable> tables)
{
	std::vector<write::SliceTable> sheets;
	for (OwnTable& own : tables)
		if (own.is_contour)
			write::append(std::move(own.table), sheets[own.sheet]);
		else
			sheets.push_back(std::move(own.table));
	return sheets;
}

// Each rank writes a part of its own. All have written before the first gets its name, and the index comes last.
Status writeParts(Team& team, const write::SliceTable& own, const std::string& path)
{
	Result<write::SlicePart> part = write::SlicePart::write(own, path, static_cast<std::size_t>(team.rank()));
	if (!part)
		return part.error();
	team.gatherAll({});
	if (Status named = part->commit(); !named)
		return named;
	team.gatherAll({});
	return team.isFirst() ? write::writePartIndex(own, path, static_cast<std::size_t>(team.size())) : Nothing{};
}

write::TraceColumns columnsOfAll(const Ranks& ranks, const grid::BlockSet& blocks, const vectors::Traces& traces)
{
	write::TraceColumns columns = write::traceColumns(blocks, traces);
	for (write::Column& column : columns.arrays)
		takeFromOwners(ranks, blocks, traces, std::as_writable_bytes(std::span(column.bytes)),
		               static_cast<std::size_t>(column.components) * grid::byteSize(column.type));
	takeFromOwners(ranks, blocks, traces, columns.cell);
	nameWholeBlocks(ranks, columns.block);
	return columns;
}

} // namespace

Status canWrite(const Ranks& ranks, const std::string& path)
{
	if (!ranks.team() || path.empty() || path == "-")
		return Nothing{};
	const Result<write::SliceFormat> format = write::sliceFormatOf(path);
	if (!format)
		return format.error();
	if (*format != write::SliceFormat::pvtp && *format != write::SliceFormat::vtm)
		return Nothing{};
	const Result<std::string> folder = write::folderOfParts(path);
	return folder ? Status(Nothing{}) : folder.error();
}

write::SliceTable tabulate(const Ranks& ranks, const grid::BlockSet& blocks, std::span<const mesh::SheetMesh> sheets,
                           std::span<const write::ContourPiece> contours)
{
	if (!ranks.team())
		return write::tabulate(blocks, sheets, 0, contours);
	return joined(gatheredTables(ranks, blocks, sheets, contours));
}

write::SliceTable gathered(const Ranks& ranks, write::SliceTable table)
{
	if (!ranks.team())
		return table;
	nameWholeBlocks(ranks, table.block);
	return gatheredRows(*ranks.team(), std::move(table));
}

Status writeSlice(const Ranks& ranks, const grid::BlockSet& blocks, std::span<const mesh::SheetMesh> sheets,
                  const std::string& path, std::span<const write::ContourPiece> contours)
{
	if (!ranks.team())
		return write::writeSlice(blocks, sheets, path, contours);
	const Result<write::SliceFormat> format = write::sliceFormatOf(path);
	if (!format)
		return format.error();
	if (*format == write::SliceFormat::pvtp)
		return writeParts(*ranks.team(), joined(ownTables(ranks, blocks, sheets, contours)), path);
	std::vector<OwnTable> tables = gatheredTables(ranks, blocks, sheets, contours);
	if (!ranks.isFirst())
		return Nothing{};
	if (*format == write::SliceFormat::vtm)
		return write::writeVtm(sheetsWithContours(std::move(tables)), path);
	return write::writeTable(joined(std::move(tables)), path);
}

Status writeTraces(const Ranks& ranks, const grid::BlockSet& blocks, std::span<const vectors::Traces> traces,
                   const std::string& path)
{
	if (!ranks.team())
		return write::writeTraces(blocks, traces, path);
	std::vector<write::TraceColumns> columns;
	for (const vectors::Traces& of_sheet : traces)
		columns.push_back(columnsOfAll(ranks, blocks, of_sheet));
	return ranks.isFirst() ? write::writeTraces(traces, columns, path) : Nothing{};
}

} // namespace vp::ranks
