#include "read/convert.h"
#include "commands/commands.h"
#include "options/spec_options.h"
#include "session/session.h"
#include "write/atomic_file.h"

#include <fmt/format.h>

#include <memory>

namespace vp::app
{

namespace
{

struct ConvertOptions
{
	SpecOptions input;
	std::vector<std::string> arrays;
	std::string output;
};

Result<ExitCode> runConvert(const ConvertOptions& options)
{
	if (Status ready = prepare(options.input); !ready)
		return ready.error();
	const view::InputSpec& input = options.input.spec.input;
	if (input.files.size() == 1 && input.files[0].starts_with("demo:"))
		return Error{ErrorKind::usage,
		             fmt::format("{}: a built-in data set is not converted; name a file", input.files[0])};
	if (input.files.size() != 1)
		return Error{ErrorKind::usage, "INPUT: convert takes one file; run it once for each"};
	if (!read::canConvertTo(options.output))
		return Error{ErrorKind::usage,
		             fmt::format("-o {}: is written as one of {}", options.output, read::kConvertEndings)};
	Result<write::AtomicFile> out = write::AtomicFile::create(options.output);
	if (!out)
		return out.error();
	if (out->beside().empty())
		return Error{ErrorKind::usage, fmt::format("-o {}: a device or pipe; name a file", options.output)};
	read::ReadOptions reading = session::readOptions(options.input.spec, input.time);
	if (!options.arrays.empty())
		reading.arrays = {.all = false, .names = options.arrays};
	if (Status done = read::convert(input.files[0], reading, options.output, out->beside()); !done)
		return done.error();
	if (Status done = out->commit(); !done)
		return done.error();
	return ExitCode::done;
}

} // namespace

void addConvert(CLI::App& program, Run& run)
{
	auto options = std::make_shared<ConvertOptions>();
	CLI::App* command = program.add_subcommand("convert", "Write an input in a format of VTK, with its kind of grid");
	addInputs(*command, options->input);
	command->add_option("--array", options->arrays, "Write this array only; give it again for several")
	    ->type_name("NAME")
	    ->expected(1)
	    ->take_all();
	command
	    ->add_option(
	        "-o,--output", options->output,
	        fmt::format("File to write: {}. The pieces of a .vtm lie in a folder of its name", read::kConvertEndings))
	    ->required()
	    ->type_name("FILE");
	command->footer("Writes one time, which --time chooses. An input of several blocks becomes a .vtm.");
	command->callback([&run, options] { run = [options] { return runConvert(*options); }; });
}

} // namespace vp::app
