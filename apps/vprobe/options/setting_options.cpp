#include "options/spec_options.h"
#include "probe/path_file.h"
#include "report/console.h"
#include "view/settings.h"
#include "view/words.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace vp::app
{

namespace
{

// Takes the name of a built-in probe, or reads a probe file.
Status chooseProbe(view::ProbeSpec& probe, const std::string& name)
{
	const Result<view::ProbeShape> shape = view::parse<view::ProbeShape>(name);
	probe.own.reset();
	if (shape)
		probe.shape = *shape;
	else if (!name.ends_with(".json"))
		return Error{ErrorKind::usage,
		             fmt::format("takes {} or a .json file", fmt::join(view::wordsOf<view::ProbeShape>(), ", "))};
	if (shape)
		return Nothing{};
	Result<probe::ProbeFile> file = probe::readProbe(name);
	if (!file)
		return file.error();
	probe.own = std::move(*file);
	probe.shape = view::ProbeShape::own;
	return Nothing{};
}

// Adds the option of a setting. What the option takes follows from the setting's place.
struct AddOption
{
	CLI::App& command;
	SpecOptions& options;
	const view::Setting& setting;

	std::string name() const
	{
		std::string option = fmt::format("--{}", setting.key);
		std::ranges::replace(option, '_', '-');
		return option;
	}
	// An error of `set` names neither the setting nor the word; both are added here.
	CLI::Option* text(std::function<Status(const std::string&)> set) const
	{
		return command.add_option_function<std::string>(
		    name(),
		    [&options = options, key = setting.key, set = std::move(set)](const std::string& word)
		    {
			    if (const Status done = set(word); !done && !options.wrong)
				    options.wrong =
				        Error{done.error().kind, fmt::format("`{}` {}: {}", key, word, done.error().message)};
		    },
		    setting.help);
	}
	template <class T>
	CLI::Option* number(T& value) const
	{
		CLI::Option* option = command.add_option(name(), value, setting.help);
		return value == T{} ? option : option->capture_default_str();
	}

	CLI::Option* operator()(std::string* value) const
	{
		return command.add_option(name(), *value, setting.help)->capture_default_str();
	}
	template <class T>
	CLI::Option* operator()(std::optional<T>* value) const
	{
		return command.add_option(name(), *value, setting.help);
	}
	CLI::Option* operator()(int* value) const { return number(*value); }
	CLI::Option* operator()(double* value) const { return number(*value); }
	CLI::Option* operator()(bool* value) const { return command.add_flag(name(), *value, setting.help); }
	CLI::Option* operator()(view::Bytes bytes) const
	{
		return number(*bytes.value)->transform(CLI::AsSizeValue(false));
	}
	CLI::Option* operator()(const view::Text& value) const
	{
		CLI::Option* option = text(value.set)->default_str(value.get().value_or(value.if_not_set));
		return value.words.empty() ? option : option->check(CLI::IsMember(value.words));
	}
	CLI::Option* operator()(const view::Texts& value) const
	{
		return command
		    .add_option_function<std::vector<std::string>>(
		        name(),
		        [&options = options, key = setting.key, set = value.set](const std::vector<std::string>& words)
		        {
			        if (const Status done = set(words); !done && !options.wrong)
				        options.wrong = Error{done.error().kind, fmt::format("`{}` {}", key, done.error().message)};
		        },
		        setting.help)
		    ->allow_extra_args(false);
	}
	CLI::Option* operator()(const view::Numbers& value) const
	{
		CLI::Option* option = command.add_option_function<std::vector<double>>(name(), value.set, setting.help);
		return value.count == 0 ? option : option->expected(static_cast<int>(value.count))->allow_extra_args(false);
	}
	CLI::Option* operator()(view::Files files) const
	{
		return command.add_option(setting.values, *files.names, setting.help);
	}
	CLI::Option* operator()(view::File file) const { return (*this)(file.name); }
	CLI::Option* operator()(view::NameOrFile file) const { return (*this)(file.name); }
	CLI::Option* operator()(view::ProbeChoice choice) const
	{
		return text([probe = choice.probe](const std::string& name) { return chooseProbe(*probe, name); })
		    ->default_str(view::text(choice.probe->shape));
	}
	CLI::Option* operator()(view::PathChoice choice) const
	{
		return text([sweep = choice.sweep](const std::string& name) { return choosePath(*sweep, name); })
		    ->default_str(view::pathKindText(*choice.sweep));
	}
};

} // namespace

namespace
{

CLI::Option* addOption(CLI::App& command, SpecOptions& options, view::Setting setting)
{
	setting.help = withOptionNames(setting.help);
	CLI::Option* option = std::visit(AddOption{command, options, setting}, setting.place);
	if (!setting.values.empty() && !std::holds_alternative<view::Files>(setting.place))
		option->type_name(setting.values);
	return option;
}

} // namespace

void addSettings(CLI::App& command, SpecOptions& options, std::string_view section, Scope scope)
{
	const view::Section all = view::sectionOf(options.spec, section);
	for (const view::Setting& setting : all.settings)
	{
		if ((setting.offer == view::Offer::in_space && scope == Scope::flat) ||
		    (setting.offer == view::Offer::flat && scope != Scope::flat) ||
		    (setting.offer == view::Offer::with_cuts && scope == Scope::no_cut))
			continue;
		CLI::Option* option = addOption(command, options, setting);
		if (*all.title)
			option->group(all.title);
	}
	// Two ways to give the same setting.
	if (section == "probe")
		command.get_option("--iso")->excludes(command.get_option("--surface"));
	if (section == "look")
		command.get_option("--window-level")->excludes(command.get_option("--range"));
}

void addMemory(CLI::App& command, SpecOptions& options)
{
	for (const view::Setting& setting : view::sectionOf(options.spec, "machine").settings)
		if (setting.key == std::string_view("memory"))
			addOption(command, options, setting);
}

CLI::Option* addInputs(CLI::App& command, SpecOptions& options)
{
	addSettings(command, options, "input");
	addTrustOptions(command);
	return command.get_option("INPUT")->required();
}

void addProbeOptions(CLI::App& command, SpecOptions& options)
{
	addSettings(command, options, "probe");
	addSettings(command, options, "machine");
}

void addExplain(CLI::App& command, SpecOptions& options)
{
	command
	    .add_flag("--explain", options.explain, "Print how each sheet will be cut in each block, and why; cut nothing")
	    ->group(view::sectionOf(options.spec, "probe").title);
}

Status choosePath(view::SweepSpec& sweep, const std::string& name)
{
	if (!name.ends_with(".json"))
		return view::setPathKind(sweep, name);
	Result<probe::Path> read = probe::readPath(name);
	if (!read)
		return read.error();
	sweep.own = std::move(*read);
	sweep.over_times = false;
	return Nothing{};
}

} // namespace vp::app
