#include "commands.h"
#include "explain.h"
#include "painter.h"
#include "saved_options.h"
#include "surface_options.h"
#include "vectors_out.h"
#include "write/png.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>

namespace vp::app
{

namespace
{

struct RenderOptions
{
	SavedOptions saved;
	std::string output;
	std::string stats;
	std::string vectors_out;
};

Result<ExitCode> runRender(RenderOptions& options)
{
	if (Status ready = prepare(options.saved); !ready)
		return ready.error();
	options.saved.probe.may_scan = !needsNeighbors(options.saved.look);
	options.saved.probe.reads_all_arrays = false;
	options.saved.probe.reads_again = false;
	if (options.saved.probe.explain)
		return explain(options.saved.probe, options.saved.look.color_by == "generation");
	if (Status place = checkWritable(options.stats); !place)
		return place.error();
	if (options.output.empty())
		return Error{ErrorKind::usage, "-o: a picture needs a place; give the name of a .png file, or -"};
	if (options.output == "-" && options.stats == "-")
		return Error{ErrorKind::usage,
		             "-o - and --stats -: standard output takes one thing at a time; name a file for the other"};
	if (options.output != "-" && std::filesystem::path(options.output).extension() != ".png")
		return Error{
		    ErrorKind::usage,
		    fmt::format("-o {}: pictures are written as .png; give a name that ends so, or -", options.output)};
	if (Status fits = checkVectorsOut(options.saved.probe.vectors, options.vectors_out,
	                                  {{"-o", options.output}, {"--stats", options.stats}});
	    !fits)
		return fits.error();
	if (Status one = requireOneSurface(options.saved.probe); !one)
		return one.error();
	Result<LookChoice> look = parseLook(options.saved.look, options.saved.probe.inputs);
	if (!look)
		return look.error();
	if (Status known = refuseGenerations(options.saved.probe, look->by_generation); !known)
		return known.error();
	options.saved.probe.reads_patches = namesPatch(look->context);

	Result<std::unique_ptr<Session>> opened = openSession(options.saved.probe, DeviceUse::draw);
	if (!opened)
		return opened.error();
	Session& session = **opened;
	if (look->by_generation)
		session.finder = find::Finder::traversal;
	Result<cut::Cut> slice = cut(session);
	if (!slice)
		return slice.error();
	if (Status told = reportWarnings(session, *slice); !told)
		return told.error();
	Result<std::vector<SheetStats>> stats = sheetStats(session, *slice);
	if (!stats)
		return stats.error();
	const std::vector<SheetStats>& sheets = *stats;
	const Result<Contours> contours = growContours(session, *slice, sheets, options.saved.look.contour, Tell::all);
	if (!contours)
		return contours.error();
	Result<Painter> painter = Painter::create(session, options.saved.probe, std::move(*look));
	if (!painter)
		return painter.error();
	Result<render::Picture> picture = painter->draw(*slice, sheets, *contours);
	if (!picture)
		return picture.error();
	if (Status written = write::writePng(*picture, options.output); !written)
		return written.error();
	if (Status written = writeVectors(session, sheets, options.vectors_out); !written)
		return written.error();
	if (Status saved = saveState(options.saved); !saved)
		return saved.error();
	return writeStats(
	    options.stats, {options.output, options.vectors_out},
	    statsJson(options.saved.probe, session, *slice, sheets, {{"contours", contoursJson(session, *contours)}}));
}

} // namespace

void addRender(CLI::App& program, Run& run)
{
	auto options = std::make_shared<RenderOptions>();
	CLI::App* command =
	    program.add_subcommand("render", "Draw the cut of an input by a probe, with legend and axes, as a PNG");
	addInputs(*command, options->saved.probe)->required(false); // --state may name them
	addProbeOptions(*command, options->saved.probe);
	addExplain(*command, options->saved.probe);
	command->add_option("-o,--output", options->output, "Picture; - writes it to standard output")
	    ->type_name("FILE.png|-");
	command->add_option("--stats", options->stats, "Figures and times as JSON")->type_name("FILE|-");

	addLookOptions(*command, options->saved.look);
	addVectorOptions(*command, options->saved.probe.vectors, &options->saved.look.vectors);
	addVectorsOut(*command, options->vectors_out);
	addContourOptions(*command, options->saved.look.contour);
	addStateOptions(*command, options->saved);
	command->callback([&run, options] { run = [options] { return runRender(*options); }; });
}

} // namespace vp::app
