#include "manual/manual.h"

#include "exit_code.h"
#include "version.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace vp::app
{

namespace
{

constexpr std::array kExitCodes{
    std::pair{ExitCode::done, "Done."},
    std::pair{ExitCode::usage, "An unknown option, or a value that cannot be."},
    std::pair{ExitCode::input, "An input that cannot be used."},
    std::pair{ExitCode::no_device, "No Vulkan device that can be used."},
    std::pair{ExitCode::output, "Output that cannot be written, and everything else."},
    std::pair{ExitCode::findings, "A check found something."},
    std::pair{ExitCode::differs, "A picture or a figure is not as expected."},
    std::pair{ExitCode::interrupted, "Ended by Ctrl-C. After other signals the code is 128 and the signal's number, as "
                                     "143 after SIGTERM."},
};

// Escapes text for roff: hyphens become minus signs, and no line begins with a request.
std::string roff(const std::string& text)
{
	std::string safe;
	for (const char c : text)
	{
		if (c == '\\')
			safe += "\\e";
		else if (c == '-')
			safe += "\\-";
		else if ((c == '.' || c == '\'') && (safe.empty() || safe.back() == '\n'))
			safe += std::string("\\&") + c;
		else
			safe += c;
	}
	return safe;
}

// Returns the text that CLI11 prints behind an option's name: the type, the default, what it needs and excludes.
struct OptionText : CLI::Formatter
{
	std::string name(const CLI::Option* option) const { return make_option_name(option, false); }
	std::string values(const CLI::Option* option) const { return make_option_opts(option); }
};

void addOption(std::string& page, const CLI::Option& option)
{
	const OptionText text;
	const bool positional = option.get_positional();
	page += fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(positional ? option.get_name(true) : text.name(&option)),
	                    roff(text.values(&option)), roff(option.get_description()));
}

std::string fullName(const CLI::App& program, const CLI::App& command)
{
	return &command == &program ? program.get_name() : program.get_name() + "-" + command.get_name();
}

void addOptions(std::string& page, const CLI::App& command)
{
	std::vector<std::string> groups;
	for (const CLI::Option* option : command.get_options())
		if (!option->get_group().empty() && std::ranges::find(groups, option->get_group()) == groups.end())
			groups.push_back(option->get_group());
	for (const std::string& group : groups)
	{
		page += group == "Options" ? std::string(".SH OPTIONS\n") : fmt::format(".SS {}\n", roff(group));
		for (const CLI::Option* option : command.get_options())
			if (option->get_group() == group)
				addOption(page, *option);
	}
}

} // namespace

std::vector<const CLI::App*> shownCommands(const CLI::App& program)
{
	return program.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::string manPage(const CLI::App& program, const CLI::App& command)
{
	const std::string name = fullName(program, command);
	std::string title = name;
	std::ranges::transform(title, title.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
	std::string page = fmt::format(".TH {} 1 \"\" \"vprobe {}\" \"Volume Probes\"\n.SH NAME\n{} \\- {}\n", roff(title),
	                               kVersion, roff(name), roff(command.get_description()));
	if (&command == &program)
	{
		page += ".SH SYNOPSIS\n.B vprobe\nCOMMAND [OPTIONS] [INPUT...]\n";
		page += ".SH DESCRIPTION\nINPUT is a file, or demo:NAME[:N], a built\\-in data set of N cells each way.\n"
		        "Each command has a manual page of its own.\n.SH COMMANDS\n";
		for (const CLI::App* sub : shownCommands(program))
			page += fmt::format(".TP\n\\fB{}\\fR\n{}. See \\fBvprobe\\-{}\\fR(1).\n", sub->get_name(),
			                    roff(sub->get_description()), sub->get_name());
	}
	else
		page += fmt::format(".SH SYNOPSIS\n.B vprobe {}\n[OPTIONS] [INPUT...]\n", command.get_name());
	addOptions(page, command);
	page += ".SH EXIT STATUS\n";
	for (const auto& [code, meaning] : kExitCodes)
		page += fmt::format(".TP\n\\fB{}\\fR\n{}\n", static_cast<int>(code), meaning);
	page += ".SH SEE ALSO\n";
	std::string others;
	if (&command != &program)
		others = "\\fBvprobe\\fR(1)";
	for (const CLI::App* sub : shownCommands(program))
		if (sub != &command)
			others += fmt::format("{}\\fBvprobe\\-{}\\fR(1)", others.empty() ? "" : ",\n", sub->get_name());
	return page + others + "\n";
}

} // namespace vp::app
