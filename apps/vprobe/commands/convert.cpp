#include "read/convert.h"
#include "commands/commands.h"
#include "commands/convert_to_file.h"
#include "interrupt.h"
#include "options/spec_options.h"
#include "session/session.h"
#include "write/file_set.h"
#include "write/xml_text.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

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

// As an index names a piece.
std::string quoted(const std::string& name)
{
	return '"' + write::xmlText(name) + '"';
}

// Writes an index and its pieces.
Status convertToSet(const std::string& input, const read::ReadOptions& reading, const std::string& output)
{
	std::error_code unknown;
	const fs::path pieces = fs::path(output).parent_path() / fs::path(output).stem();
	if (fs::exists(fs::symlink_status(pieces, unknown)) && !fs::exists(output, unknown))
		return write::folderIsThere(pieces.string());
	Result<write::FileSet> set = write::FileSet::create(output);
	if (!set)
		return set.error();
	if (Status done = read::convert(input, reading, output, set->folder()); !done)
		return done;
	const DeferredInterrupt writing; // the files appear together
	std::string index;
	std::vector<std::pair<std::string, std::string>> renamed;
	for (const fs::directory_entry& file : fs::directory_iterator(set->folder(), unknown))
	{
		const std::string name = file.path().filename().string();
		if (name == fs::path(output).filename())
		{
			std::ifstream text(file.path(), std::ios::binary);
			index.assign(std::istreambuf_iterator<char>(text), {});
			continue;
		}
		const std::string written = pieces.filename().string() + "/" + name;
		if (const std::string target = set->add(name).name; target != written)
			renamed.emplace_back(quoted(written), quoted(target));
	}
	for (const auto& [before, after] : renamed)
	{
		const std::size_t at = index.find(before);
		if (at == index.npos)
			return Error{ErrorKind::output,
			             fmt::format("{}: its older pieces are in the way; remove it first", output)};
		index.replace(at, before.size(), after);
	}
	return set->commit(index, true);
}

// Takes the last of several inputs for the output if none is named: convert FILE OUT.
Status chooseOutput(ConvertOptions& options)
{
	if (!options.output.empty())
		return Nothing{};
	std::vector<std::string>& files = options.input.spec.input.files;
	if (files.size() < 2 || !read::canConvertTo(files.back()))
		return Error{ErrorKind::usage, fmt::format("-o: name the file to write, one of {}", read::kConvertEndings)};
	std::error_code unknown;
	if (fs::exists(fs::symlink_status(files.back(), unknown)))
		return Error{ErrorKind::usage, fmt::format("{0}: is there already; give -o {0} to replace it", files.back())};
	options.output = files.back();
	files.pop_back();
	return Nothing{};
}

Result<ExitCode> runConvert(ConvertOptions& options)
{
	if (Status chosen = chooseOutput(options); !chosen)
		return chosen.error();
	if (Status ready = prepare(options.input); !ready)
		return ready.error();
	const view::InputSpec& input = options.input.spec.input;
	if (input.files.size() != 1)
		return Error{ErrorKind::usage, "INPUT: convert takes one file; run it once for each"};
	if (input.cell_to_point)
		return Error{ErrorKind::usage,
		             "`cell_to_point`: a file is converted with its arrays as they are; leave it out"};
	if (!read::canConvertTo(options.output))
		return Error{ErrorKind::usage,
		             fmt::format("-o {}: is written as one of {}", options.output, read::kConvertEndings)};
	read::ReadOptions reading = session::readOptions(options.input.spec, input.time);
	reading.stays_above = session::memoryForParts(options.input.spec);
	if (!options.arrays.empty())
		reading.arrays = {.all = false, .names = options.arrays};
	const bool is_index = fs::path(options.output).extension() == ".vtm";
	const Status done = is_index ? convertToSet(input.files[0], reading, options.output)
	                             : convertToFile(input.files[0], reading, options.output);
	return done ? Result<ExitCode>(ExitCode::done) : done.error();
}

} // namespace

void addConvert(CLI::App& program, Run& run)
{
	auto options = std::make_shared<ConvertOptions>();
	CLI::App* command = program.add_subcommand("convert", "Write an input in a format of VTK, with its kind of grid");
	addInputs(*command, options->input);
	addMemory(*command, options->input);
	command->add_option("--array", options->arrays, "Write this array only; give it again for several")
	    ->type_name("NAME")
	    ->expected(1)
	    ->take_all();
	command
	    ->add_option(
	        "-o,--output", options->output,
	        fmt::format("File to write: {}. The pieces of a .vtm lie in a folder of its name", read::kConvertEndings))
	    ->type_name("FILE");
	command->footer(
	    "Writes one time, which --time chooses. An input of several blocks becomes a .vtm. A .vtu may hold any "
	    "grid of one block. Without -o, the last name is the file to write.");
	command->callback([&run, options] { run = [options] { return runConvert(*options); }; });
}

} // namespace vp::app
