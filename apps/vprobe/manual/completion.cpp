#include "manual/manual.h"
#include "render/color/color_map.h"
#include "view/words.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace vp::app
{

namespace
{

// Says what may follow an option.
struct ValueOf
{
	std::vector<std::string> words{}; // one of these
	bool is_array = false;            // the name of an array of the input
	bool is_file = false;
};

// Returns the words in a type's name, which is {a,b,c}, or a|b|c in small letters.
std::vector<std::string> wordsIn(const std::string& type)
{
	const std::size_t begin = type.find('{');
	const std::size_t end = type.find('}');
	if (begin != std::string::npos && end != std::string::npos && begin < end)
		return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
	std::vector<std::string> words;
	for (std::string& word : CLI::detail::split(type, '|'))
		if (!word.empty() && std::ranges::all_of(word, [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; }))
			words.push_back(std::move(word));
	return words;
}

ValueOf valueOf(const CLI::Option& option)
{
	const std::string name = option.get_name();
	ValueOf value;
	if (name.find("--probe") != std::string::npos)
		value.words = view::wordsOf<view::ProbeShape>();
	else if (name.find("colormap") != std::string::npos)
		value.words = render::colorMapNames();
	else
		value.words = wordsIn(option.get_type_name());
	value.is_array =
	    option.get_type_name().find("NAME") != std::string::npos && name.find("array") != std::string::npos;
	value.is_file = option.get_type_name().find("FILE") != std::string::npos || option.get_positional();
	return value;
}

std::vector<const CLI::Option*> namedOptions(const CLI::App& command)
{
	return command.get_options([](const CLI::Option* option)
	                           { return !option->get_positional() && !option->get_group().empty(); });
}

std::vector<std::string> namesOf(const CLI::Option& option)
{
	std::vector<std::string> names;
	for (const std::string& name : option.get_snames())
		names.push_back("-" + name);
	for (const std::string& name : option.get_lnames())
		names.push_back("--" + name);
	return names;
}

// Puts text between apostrophes for a shell.
std::string shellWord(const std::string& text)
{
	std::string safe;
	for (const char c : text)
		safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
	return "'" + safe + "'";
}

// Escapes a description that stands within [...] of zsh's _arguments.
std::string inBrackets(const std::string& text)
{
	std::string safe;
	for (const char c : text)
		safe += (c == '[' || c == ']' || c == ':' || c == '\\') ? std::string("\\") + c : std::string(1, c);
	return safe;
}

std::string zshArgument(const CLI::Option& option, const std::string& name)
{
	std::string argument = fmt::format("*{}[{}]", name, inBrackets(option.get_description()));
	if (option.get_items_expected_max() == 0)
		return shellWord(argument);
	const ValueOf value = valueOf(option);
	const std::string action = value.is_array         ? "_vprobe_arrays"
	                           : !value.words.empty() ? fmt::format("({})", fmt::join(value.words, " "))
	                           : value.is_file        ? "_files"
	                                                  : " ";
	for (int i = 0; i < std::clamp(option.get_items_expected(), 1, 9); ++i)
		argument += fmt::format(":{}:{}", inBrackets(option.get_type_name()), action);
	return shellWord(argument);
}

} // namespace

std::string bashCompletion(const CLI::App& program)
{
	std::string options;
	std::string values;
	std::vector<std::string> names;
	for (const CLI::App* command : shownCommands(program))
	{
		names.push_back(command->get_name());
		std::vector<std::string> all;
		for (const CLI::Option* option : namedOptions(*command))
		{
			const std::vector<std::string> own = namesOf(*option);
			all.insert(all.end(), own.begin(), own.end());
			const ValueOf value = valueOf(*option);
			if (!value.is_array && value.words.empty())
				continue;
			for (const std::string& name : own)
				values += fmt::format("\t{}:{}) words={} ;;\n", command->get_name(), name,
				                      value.is_array ? "$(_vprobe_arrays)"
				                                     : shellWord(fmt::format("{}", fmt::join(value.words, "\n"))));
		}
		options += fmt::format("\t{}) options={} ;;\n", command->get_name(),
		                       shellWord(fmt::format("{}", fmt::join(all, " "))));
	}
	return fmt::format(R"(# Completion of vprobe for bash; made by "vprobe manual --completion bash".

# The arrays of the inputs on the command line.
_vprobe_arrays()
{{
	local word
	for word in "${{COMP_WORDS[@]:2}}"; do
		if [[ -f $word ]]; then
			timeout 3 vprobe manual --arrays "$word" 2>/dev/null
		fi
	done
}}

_vprobe()
{{
	local IFS=$' \t\n' word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command=${{COMP_WORDS[1]-}}
	local options='' words=''
	COMPREPLY=()
	if ((COMP_CWORD == 1)); then
		mapfile -t COMPREPLY < <(compgen -W '{} --help --version' -- "$word")
		return
	fi
	case $command in
{}	esac
	if [[ $word == -* ]]; then
		mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
		return
	fi
	case $command:$before in
{}	esac
	if [[ $words ]]; then
		IFS=$'\n' # one a line, since names of arrays may have blanks
		mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
	fi
	((${{#COMPREPLY[@]}})) || mapfile -t COMPREPLY < <(compgen -f -- "$word")
}}

complete -o filenames -F _vprobe vprobe
)",
	                   fmt::join(names, " "), options, values);
}

std::string zshCompletion(const CLI::App& program)
{
	std::string commands;
	std::string cases;
	for (const CLI::App* command : shownCommands(program))
	{
		commands +=
		    fmt::format("\t\t{}\n", shellWord(fmt::format("{}:{}", command->get_name(), command->get_description())));
		cases += fmt::format("\t{})\n\t\t_arguments -S \\\n", command->get_name());
		for (const CLI::Option* option : namedOptions(*command))
			for (const std::string& name : namesOf(*option))
				cases += fmt::format("\t\t\t{} \\\n", zshArgument(*option, name));
		cases += "\t\t\t'*:input:_files'\n\t\t;;\n";
	}
	return fmt::format(R"(#compdef vprobe
# Completion of vprobe for zsh; made by "vprobe manual --completion zsh".

# The arrays of the inputs on the command line.
_vprobe_arrays()
{{
	local word
	local -a names
	for word in "${{words[@]:1}}"; do
		[[ -f $word ]] && names+=("${{(@f)$(timeout 3 vprobe manual --arrays $word 2>/dev/null)}}")
	done
	compadd -a names
}}

_vprobe()
{{
	local -a commands
	commands=(
{}	)
	if ((CURRENT == 2)); then
		_describe command commands
		return
	fi
	local command=$words[2]
	shift words
	((CURRENT--))
	case $command in
{}	esac
}}

_vprobe "$@"
)",
	                   commands, cases);
}

} // namespace vp::app
