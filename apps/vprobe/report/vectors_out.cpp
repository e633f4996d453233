#include "report/vectors_out.h"

#include "ranks/data/share.h"
#include "ranks/particles/joined_traces.h"
#include "team.h"
#include "write/particle_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <span>
#include <vector>

namespace vp::app
{

namespace
{

// Each row comes from the rank that has the point's cell.
write::TraceColumns columnsOfTeam(const session::Session& session, const vectors::Traces& traces)
{
	const ranks::ParticleBorders& borders = session.particle_borders->of(*session.team, *session.share, session.blocks);
	write::TraceColumns columns = write::traceColumns(session.blocks, traces);
	for (write::Column& column : columns.arrays)
		ranks::takeFromOwners(*session.team, borders, traces, std::as_writable_bytes(std::span(column.bytes)),
		                      static_cast<std::size_t>(column.components) * grid::byteSize(column.type));
	ranks::takeFromOwners(*session.team, borders, traces, columns.cell);
	for (std::int32_t& block : columns.block)
		block = static_cast<std::int32_t>(session.share->whole[static_cast<std::size_t>(block)]);
	return columns;
}

} // namespace

void addVectorsOut(CLI::App& command, std::string& file)
{
	command
	    .add_option(
	        "--vectors-out", file,
	        "Write the paths of the particles as polylines with every array, the time, and the reason why each ends")
	    ->type_name("FILE.vtp|-")
	    ->group("Vectors");
}

Status checkVectorsOut(const view::VectorSpec& vectors, const std::string& file, const std::vector<OtherOutput>& others)
{
	if (file.empty())
		return Nothing{};
	if (!vectors.on())
		return Error{ErrorKind::usage,
		             fmt::format("--vectors-out {}: nothing is launched; add --vectors tufts, or lines", file)};
	if (file != "-" && std::filesystem::path(file).extension() != ".vtp")
		return Error{ErrorKind::usage,
		             fmt::format("--vectors-out {}: paths are written as .vtp; give a name that ends so, or -", file)};
	for (const OtherOutput& other : others)
		if (file == "-" && other.file == "-")
			return Error{ErrorKind::usage, fmt::format("--vectors-out - and {} -: standard output takes one thing at a "
			                                           "time; name a file for the other",
			                                           other.option)};
	return checkWritable(file);
}

Status writeVectors(const session::Session& session, const std::vector<session::SheetStats>& sheets,
                    const std::string& file)
{
	if (file.empty())
		return Nothing{};
	const TimedSection section(session.timeline.get(), "write");
	std::vector<vectors::Traces> traces;
	for (const session::SheetStats& sheet : sheets)
		traces.push_back(*sheet.traces);
	if (!session.team)
		return write::writeTraces(session.blocks, traces, file);
	std::vector<write::TraceColumns> columns;
	for (const vectors::Traces& of_sheet : traces)
		columns.push_back(columnsOfTeam(session, of_sheet));
	return isFirst() ? write::writeTraces(traces, columns, file) : Nothing{};
}

} // namespace vp::app
