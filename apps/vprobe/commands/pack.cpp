#include "commands/commands.h"
#include "commands/convert_to_file.h"
#include "options/spec_options.h"
#include "session/session.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace vp::app
{

namespace
{

struct PackOptions
{
	SpecOptions input;
	std::vector<std::string> arrays;
	std::string output;
	int part = kUsualPart;
	CLI::Option* time = nullptr; // that of the input
};

Result<ExitCode> runPack(PackOptions& options)
{
	if (Status ready = prepare(options.input); !ready)
		return ready.error();
	const view::InputSpec& input = options.input.spec.input;
	if (input.files.size() != 1)
		return Error{ErrorKind::usage, "INPUT: pack takes one file; run it once for each"};
	if (input.cell_to_point)
		return Error{ErrorKind::usage, "`cell_to_point`: a file is packed with its arrays as they are; leave it out"};
	if (std::filesystem::path(options.output).extension() != ".vtkhdf")
		return Error{ErrorKind::usage, fmt::format("-o {}: packs are written as .vtkhdf", options.output)};
	read::ReadOptions reading = session::readOptions(options.input.spec, input.time);
	reading.stays_above = session::memoryForParts(options.input.spec);
	reading.cells_of_part = static_cast<std::size_t>(options.part);
	reading.all_times = options.time->empty();
	if (!options.arrays.empty())
		reading.arrays = {.all = false, .names = options.arrays};
	const Status done = convertToFile(input.files[0], reading, options.output);
	return done ? Result<ExitCode>(ExitCode::done) : done.error();
}

} // namespace

void addPack(CLI::App& program, Run& run)
{
	auto options = std::make_shared<PackOptions>();
	CLI::App* command =
	    program.add_subcommand("pack", "Write an input in parts that lie together in space, for cuts that read little");
	addInputs(*command, options->input);
	options->time = command->get_option("--time");
	addMemory(*command, options->input);
	command->add_option("--array", options->arrays, "Write this array only; give it again for several")
	    ->type_name("NAME")
	    ->expected(1)
	    ->take_all();
	command->add_option("-o,--output", options->output, "File to write, a .vtkhdf")->type_name("FILE")->required();
	addPartSize(*command, options->part);
	command->footer(
	    "Writes all times of a grid that stands still, or the one that --time chooses. An image gets bricks of "
	    "some 32 points a side.");
	command->callback([&run, options] { run = [options] { return runPack(*options); }; });
}

} // namespace vp::app
