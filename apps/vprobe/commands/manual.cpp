#include "manual/manual.h"
#include "commands/commands.h"
#include "read/read.h"
#include "report/console.h"
#include "view/state_schema.h"
#include "write/atomic_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <set>

namespace vp::app
{

namespace
{

struct ManualOptions
{
	const CLI::App* program = nullptr;
	std::string pages;
	std::string shell;
	std::string input;
	bool schema = false;
};

Status writePages(const CLI::App& program, const std::filesystem::path& folder)
{
	const auto writeOne = [&](const CLI::App& command)
	{
		const std::string name =
		    &command == &program ? std::string("vprobe") : fmt::format("vprobe-{}", command.get_name());
		Result<write::AtomicFile> page = write::AtomicFile::create((folder / (name + ".1")).string());
		if (!page)
			return Status(page.error());
		page->write(manPage(program, command));
		return page->commit();
	};
	if (Status written = writeOne(program); !written)
		return written;
	for (const CLI::App* command : shownCommands(program))
		if (Status written = writeOne(*command); !written)
			return written;
	return Nothing{};
}

Status printArrays(const std::string& input)
{
	const Result<grid::BlockSet> blocks = read::readInputs({input}, {}, nullptr);
	if (!blocks)
		return blocks.error();
	std::set<std::string> names;
	for (const grid::Block& block : blocks->blocks)
		for (const grid::Field& field : block.fields)
			names.insert(field.name);
	for (const std::string& name : names)
		print("{}\n", name);
	return Nothing{};
}

Result<ExitCode> runManual(const ManualOptions& options)
{
	if (!options.pages.empty())
		if (Status written = writePages(*options.program, options.pages); !written)
			return written.error();
	if (!options.shell.empty())
		print("{}", options.shell == "bash" ? bashCompletion(*options.program) : zshCompletion(*options.program));
	if (!options.input.empty())
		if (Status printed = printArrays(options.input); !printed)
			return printed.error();
	if (options.schema)
		print("{}", view::stateSchema());
	return ExitCode::done;
}

} // namespace

// This command is for people who make packages, and for the completion scripts. The help does not show it.
void addManual(CLI::App& program, Run& run)
{
	auto options = std::make_shared<ManualOptions>();
	options->program = &program;
	CLI::App* command = program.add_subcommand("manual", "Write manual pages and scripts of completion")->group("");
	CLI::Option* pages =
	    command->add_option("--pages", options->pages, "Write a page for man for each command")->type_name("FOLDER");
	CLI::Option* shell = command->add_option("--completion", options->shell, "Print a script for this shell")
	                         ->check(CLI::IsMember({"bash", "zsh"}));
	CLI::Option* arrays =
	    command->add_option("--arrays", options->input, "Print the names of an input's arrays")->type_name("INPUT");
	CLI::Option* schema =
	    command->add_flag("--schema", options->schema, "Print the JSON schema of the files that --save writes");
	command->callback(
	    [&run, options, pages, shell, arrays, schema]
	    {
		    if (pages->count() + shell->count() + arrays->count() + schema->count() == 0)
			    throw CLI::RequiredError("One of --pages, --completion, --arrays and --schema");
		    run = [options] { return runManual(*options); };
	    });
}

} // namespace vp::app
