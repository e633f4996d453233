#include "commands/commands.h"
#include "commands/convert_to_file.h"
#include "options/spec_options.h"
#include "read/read_ahead.h"
#include "read/source_stamp.h"
#include "session/session.h"

#include <fmt/format.h>

#include <memory>

namespace vp::app
{

namespace
{

struct IndexOptions
{
	SpecOptions input;
	int part = kUsualPart;
};

Result<ExitCode> runIndex(IndexOptions& options)
{
	if (Status ready = prepare(options.input); !ready)
		return ready.error();
	const view::InputSpec& input = options.input.spec.input;
	if (input.files.size() != 1)
		return Error{ErrorKind::usage, "INPUT: an index is of one file; run it once for each"};
	if (input.files[0].starts_with(read::kDemoPrefix))
		return Error{ErrorKind::usage,
		             fmt::format("{}: a built-in data set has no file to index; name a file", input.files[0])};
	const view::InputSpec as_it_is{.files = input.files, .inputs_as = input.inputs_as};
	if (!(input == as_it_is))
		return Error{ErrorKind::usage,
		             "an index is of the file as it is; leave out what changes how INPUT is read, such as --displace"};
	read::ReadOptions reading = session::readOptions(options.input.spec, input.time);
	reading.cells_of_part = static_cast<std::size_t>(options.part);
	reading.all_times = true;
	const Status done = convertToFile(input.files[0], reading, input.files[0] + std::string(read::kIndexEnding));
	return done ? Result<ExitCode>(ExitCode::done) : done.error();
}

} // namespace

void addIndex(CLI::App& program, Run& run)
{
	auto options = std::make_shared<IndexOptions>();
	CLI::App* command = program.add_subcommand(
	    "index", "Write what cuts need to know of an input beside it, so that they read little of it");
	addInputs(*command, options->input);
	addPartSize(*command, options->part);
	command->footer("Writes INPUT.vpx: points and cells in parts that lie together in space. Values stay in INPUT if "
	                "they lie there as plain numbers. The index is used as long as INPUT stays as it is; then run this "
	                "again.");
	command->callback([&run, options] { run = [options] { return runIndex(*options); }; });
}

} // namespace vp::app
