#include "base/user_folder.h"
#include "commands/commands.h"
#include "commands/convert_to_file.h"
#include "options/spec_options.h"
#include "read/file_index.h"
#include "read/read_ahead.h"
#include "report/console.h"
#include "session/session.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include <unistd.h>

namespace vp::app
{

namespace
{

struct IndexOptions
{
	SpecOptions input;
	int part = kUsualPart;
	bool in_cache = false;
};

// Returns where the index goes: beside the file if it may.
Result<std::string> placeFor(const std::string& file, bool in_cache)
{
	namespace fs = std::filesystem;
	const fs::path folder = fs::path(file).parent_path();
	std::error_code failed;
	const bool is_writable = access(folder.empty() ? "." : folder.c_str(), W_OK) == 0;
	if ((!in_cache && is_writable) || !fs::exists(file, failed)) // that it is not there is told when it is read
		return read::indexBeside(file);
	const std::string index = read::indexInCache(file);
	if (index.empty() || madeFolder(fs::path(index).parent_path()).empty())
		return Error{ErrorKind::output, fmt::format("{}: there is no cache folder for its index; set XDG_CACHE_HOME to "
		                                            "a folder where you may write",
		                                            file)};
	if (!in_cache)
		print("you may not write into the folder of {}; the index is {}\n", file, index);
	return index;
}

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
	const Result<std::string> index = placeFor(input.files[0], options.in_cache);
	if (!index)
		return index.error();
	const Status done = convertToFile(input.files[0], reading, *index);
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
	command->add_flag(
	    "--in-cache", options->in_cache,
	    "Write the index into $XDG_CACHE_HOME/volume-probes, or ~/.cache/volume-probes, and not beside INPUT");
	command->footer("Writes INPUT.vpx: points and cells in parts that lie together in space. Values stay in INPUT if "
	                "they lie there as plain numbers. The index is used as long as INPUT stays as it is; then run this "
	                "again. Where you may not write beside INPUT, it goes into your cache folder.");
	command->callback([&run, options] { run = [options] { return runIndex(*options); }; });
}

} // namespace vp::app
