#include "report/team_slice.h"

#include "interrupt.h"
#include "ranks/data/share.h"
#include "ranks/team.h"
#include "write/file_set.h"
#include "write/slice_file.h"
#include "write/slice_parts.h"
#include "write/slice_sets.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace vp::app
{

namespace
{

template <class T>
void putNumbers(ranks::MessageWriter& to, const T& numbers)
{
	to.putAll(std::span(numbers.data(), numbers.size()));
}

template <class T>
void takeNumbers(ranks::MessageReader& from, T& numbers)
{
	const auto all = from.getAll<typename T::value_type>();
	numbers.resize(all.size());
	std::copy(all.begin(), all.end(), numbers.begin());
}

void putColumns(ranks::MessageWriter& to, const std::vector<write::Column>& columns)
{
	for (const write::Column& column : columns)
		to.putAll(column.bytes);
}

// Names and types are the same at all ranks, since each knows the arrays of all blocks.
ranks::Bytes messageOf(const write::SliceTable& table)
{
	ranks::MessageWriter message;
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

write::SliceTable tableOf(const ranks::Bytes& bytes, const write::SliceTable& like)
{
	ranks::MessageReader reader(bytes);
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
write::SliceTable gathered(ranks::Team& team, write::SliceTable own)
{
	// Along the tree, tables come together in the order of ranks.
	ranks::Bytes bytes = messageOf(own);
	team.reduce(bytes,
	            [&](ranks::Bytes& into, const ranks::Bytes& other)
	            {
		            write::SliceTable table = tableOf(into, own);
		            write::append(tableOf(other, own), table);
		            into = messageOf(table);
	            });
	return tableOf(bytes, own);
}

void nameWholeBlocks(const ranks::Share& share, write::SliceTable& table)
{
	for (std::int32_t& block : table.block)
		block = static_cast<std::int32_t>(share.whole[static_cast<std::size_t>(block)]);
}

// The polygons that this rank has of a sheet, or of one contour.
struct OwnTable
{
	write::SliceTable table;
	std::size_t sheet;
	bool is_contour;
};

// Sheets come first.
std::vector<OwnTable> ownTables(const session::Session& session, const session::Frame& frame)
{
	const grid::BlockSet& blocks = frame.slice.blocksOf(session.blocks);
	const std::vector<mesh::SheetMesh> meshes = session::exportedMeshes(frame.sheets);
	const std::vector<write::ContourPiece> contours = session::contourPieces(frame.contours);
	std::vector<OwnTable> tables;
	for (std::size_t s = 0; s < meshes.size(); ++s)
	{
		tables.push_back({write::tabulate(blocks, std::span(meshes).subspan(s, 1), s), s, false});
		if (!contours.empty())
			write::addContourColumn(tables.back().table);
	}
	for (const write::ContourPiece& contour : contours)
		tables.push_back(
		    {write::tabulate(blocks, {}, 0, {&contour, 1}), static_cast<std::size_t>(contour.sheet), true});
	for (OwnTable& own : tables)
		nameWholeBlocks(*session.share, own.table);
	return tables;
}

// The same of all ranks, at the first one.
std::vector<OwnTable> gatheredTables(const session::Session& session, const session::Frame& frame)
{
	std::vector<OwnTable> tables = ownTables(session, frame);
	for (OwnTable& own : tables)
		own.table = gathered(*session.team, std::move(own.table));
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
Status writeParts(ranks::Team& team, const write::SliceTable& own, const std::string& path)
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

} // namespace

Status checkWritableTogether(const std::string& path)
{
	if (path.empty() || path == "-")
		return Nothing{};
	const Result<write::SliceFormat> format = write::sliceFormatOf(path);
	if (!format)
		return format.error();
	if (*format != write::SliceFormat::pvtp && *format != write::SliceFormat::vtm)
		return Nothing{};
	const Result<std::string> folder = write::folderOfParts(path);
	return folder ? Status(Nothing{}) : folder.error();
}

write::SliceTable tableOf(const session::Session& session, const session::Frame& frame)
{
	if (session.team)
		return joined(gatheredTables(session, frame));
	return write::tabulate(frame.slice.blocksOf(session.blocks), session::exportedMeshes(frame.sheets), 0,
	                       session::contourPieces(frame.contours));
}

write::SliceTable tableAlong(const session::Session& session, const session::Frame& frame, std::size_t sheet,
                             const write::SheetLine& line)
{
	write::SliceTable table = write::tabulateAlong(frame.slice.blocksOf(session.blocks),
	                                               frame.slice.sheets[sheet].sheet, frame.sheets[sheet].mesh, line);
	if (!session.team)
		return table;
	nameWholeBlocks(*session.share, table);
	return gathered(*session.team, std::move(table));
}

Status writeTogether(const session::Session& session, const session::Frame& frame, const std::string& path)
{
	const TimedSection section(session.timeline.get(), "write");
	const Result<write::SliceFormat> format = write::sliceFormatOf(path);
	if (!format)
		return format.error();
	ranks::Team& team = *session.team;
	if (*format == write::SliceFormat::pvtp)
		return writeParts(team, joined(ownTables(session, frame)), path);
	std::vector<OwnTable> tables = gatheredTables(session, frame);
	if (*format == write::SliceFormat::vtm)
	{
		const DeferredInterrupt writing; // its files appear together
		return team.isFirst() ? write::writeVtm(sheetsWithContours(std::move(tables)), path) : Nothing{};
	}
	return team.isFirst() ? write::writeTable(joined(std::move(tables)), path) : Nothing{};
}

} // namespace vp::app
