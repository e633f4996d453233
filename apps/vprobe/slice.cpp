#include "commands.h"
#include "interrupt.h"
#include "saved_options.h"
#include "stats_json.h"
#include "surface_options.h"
#include "write/slice_file.h"

#include <fmt/format.h>

#include <memory>

namespace vp::app
{

namespace
{

struct SliceOptions
{
	SavedOptions saved;
	std::string output;
	std::string stats;
};

Result<ExitCode> runSlice(SliceOptions& options)
{
	if (Status ready = prepare(options.saved); !ready)
		return ready.error();
	if (Status one = requireOneSurface(options.saved.probe); !one)
		return one.error();
	if (options.output == "-" && options.stats == "-")
		return Error{ExitCode::usage,
		             "-o - and --stats -: standard output takes one thing at a time; name a file for the other"};
	if (!options.output.empty())
		if (Result<write::SliceFormat> format = write::sliceFormatOf(options.output); !format)
			return format.error();

	Result<std::unique_ptr<Session>> opened = openSession(options.saved.probe, DeviceUse::classify);
	if (!opened)
		return opened.error();
	Session& session = **opened;
	session.crinkle = options.saved.look.crinkle;
	Result<slice::Slice> slice = cut(session);
	if (!slice)
		return slice.error();
	if (Status told = tellAbout(session, *slice); !told)
		return told.error();
	std::vector<SheetStats> sheets = sheetStats(session, *slice);

	if (!options.output.empty())
	{
		const TimedSection section(session.timeline.get(), "write");
		const DeferredInterrupt writing; // the files of a .vtm appear together
		if (Status written = write::writeSlice(session.blocks, exportedMeshes(sheets), options.output); !written)
			return written.error();
	}
	if (options.output.empty() && options.stats.empty())
		fmt::print("{}", statsTable(session, *slice, sheets));
	if (Status saved = saveState(options.saved); !saved)
		return saved.error();
	return writeStats(options.stats, options.output, statsJson(options.saved.probe, session, *slice, sheets));
}

} // namespace

void addSlice(CLI::App& program, Run& run)
{
	auto options = std::make_shared<SliceOptions>();
	CLI::App* command =
	    program.add_subcommand("slice", "Cut an input by a plane: polygons with every array, and figures");
	addInputs(*command, options->saved.probe)->required(false); // --state may name them
	addProbeOptions(*command, options->saved.probe);
	command
	    ->add_option("-o,--output", options->output,
	                 "Polygons as .vtp, .vtm (a .vtp a sheet), .ply or .csv; - writes VTP to standard output")
	    ->type_name("FILE|-");
	command->add_option("--stats", options->stats, "Figures and times as JSON")->type_name("FILE|-");
	addCrinkleOption(*command, options->saved.look);
	command->footer("With neither -o nor --stats a short table is printed.");
	addStateOptions(*command, options->saved);
	command->callback([&run, options] { run = [options] { return runSlice(*options); }; });
}

} // namespace vp::app
