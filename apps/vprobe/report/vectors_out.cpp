#include "report/vectors_out.h"

#include "ranks/write/joined_tables.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <vector>

namespace vp::app
{

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
	const TimedSection section(session.timeline(), "write");
	std::vector<vectors::Traces> traces;
	for (const session::SheetStats& sheet : sheets)
		traces.push_back(*sheet.traces);
	return ranks::writeTraces(session.ranks(), session.blocks(), traces, file);
}

} // namespace vp::app
