#include "base/messages.h"
#include "base/progress.h"
#include "commands/commands.h"
#include "grid/field_choice.h"
#include "options/spec_options.h"
#include "report/sample_points.h"
#include "session/session.h"
#include "view/validate.h"
#include "write/atomic_file.h"
#include "write/sample_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

namespace vp::app
{

namespace
{

struct SampleOptions
{
	SpecOptions input;
	std::string points;
	std::vector<double> line; // empty, or where it begins, where it ends, and how many points
	std::vector<std::string> arrays;
	std::string output = "-";
};

Result<std::vector<Vec3>> pointsOf(const SampleOptions& options)
{
	if (options.points.empty() == options.line.empty())
		return Error{ErrorKind::usage, "sample: takes points from one place; give either --points or --line"};
	return options.line.empty() ? readPoints(options.points) : pointsOnLine(options.line);
}

Result<std::vector<grid::FieldChoice>> chooseArrays(const SampleOptions& options, const grid::BlockSet& blocks)
{
	std::vector<grid::FieldChoice> chosen;
	for (const std::string& array : options.arrays)
	{
		Result<std::optional<grid::FieldChoice>> choice = grid::chooseField(blocks, array);
		if (!choice)
			return choice.error();
		if (*choice)
			chosen.push_back(**choice);
	}
	return chosen;
}

Result<ExitCode> runSample(const SampleOptions& options)
{
	// Checks the command line before a large file is read.
	if (Status ready = prepare(options.input); !ready)
		return ready.error();
	const view::ViewSpec& spec = options.input.spec;
	if (Status level = view::requireLevel(spec.input, "vprobe sample"); !level)
		return level.error();
	Result<std::vector<Vec3>> points = pointsOf(options);
	if (!points)
		return points.error();
	if (Status place = write::checkWritable(options.output); !place)
		return place.error();
	Result<grid::BlockSet> blocks = [&]
	{
		const Progress progress(fmt::format("reading {}", fmt::join(spec.input.files, ", ")));
		return session::readInputs(spec);
	}();
	if (!blocks)
		return blocks.error();
	Result<std::vector<grid::FieldChoice>> chosen = chooseArrays(options, *blocks);
	if (!chosen)
		return chosen.error();
	Result<std::size_t> outside = [&]
	{
		const Progress progress("sampling");
		return write::writeSamples(*blocks, *points, *chosen, options.output);
	}();
	if (!outside)
		return outside.error();
	if (points->empty())
		warn("{}: holds no points", options.points == "-" ? "standard input" : options.points);
	if (*outside > 0)
		warn("{} of {} points lie outside the grid; their values are nan", *outside, points->size());
	return ExitCode::done;
}

} // namespace

void addSample(CLI::App& program, Run& run)
{
	auto options = std::make_shared<SampleOptions>();
	CLI::App* command = program.add_subcommand("sample", "Values of the arrays at points or along a line, as CSV");
	addInputs(*command, options->input);
	command
	    ->add_option(
	        "--points", options->points,
	        "Text file with three numbers per line, separated by blanks, commas or semicolons, or CSV with columns "
	        "x, y and z; - reads standard input")
	    ->type_name("FILE|-");
	command
	    ->add_option("--line", options->line, "N points from X0 Y0 Z0 to X1 Y1 Z1, evenly spread, both ends among them")
	    ->expected(7)
	    ->allow_extra_args(false)
	    ->type_name("X0 Y0 Z0 X1 Y1 Z1 N");
	command->add_option("--array", options->arrays, "Array to write. May be given several times (default: all arrays)")
	    ->allow_extra_args(false)
	    ->type_name("[point:|cell:]NAME");
	command->add_option("-o,--output", options->output, "CSV")->type_name("FILE|-")->capture_default_str();
	command->footer("Columns: x, y, z, block, cell, then the arrays. docs/SAMPLING.md says how they are interpolated.");
	command->callback([&run, options] { run = [options] { return runSample(*options); }; });
}

} // namespace vp::app
