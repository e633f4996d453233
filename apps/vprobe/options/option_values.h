#pragma once

#include "options/spec_options.h"
#include "view/words.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace vp::app
{

// These functions add options that fill the typed values of a ViewSpec.

// Returns the key of an option's setting: "--color-by" is `color_by`.
inline std::string keyOf(const char* option)
{
	std::string key = option + 2;
	std::ranges::replace(key, '-', '_');
	return key;
}

// Adds an option that takes one word. An error of `set` needs to name neither the setting nor the word; both are added
// here.
inline CLI::Option* addText(CLI::App& command, SpecOptions& options, const char* name,
                            std::function<Status(const std::string&)> set, const std::string& help)
{
	return command.add_option_function<std::string>(
	    name,
	    [&options, name, set = std::move(set)](const std::string& word)
	    {
		    if (const Status done = set(word); !done && !options.wrong)
			    options.wrong =
			        Error{done.error().kind, fmt::format("`{}` {}: {}", keyOf(name), word, done.error().message)};
	    },
	    help);
}

// Adds such an option with a function that parses the word into `value`.
template <class T, class Parse>
CLI::Option* addText(CLI::App& command, SpecOptions& options, const char* name, T& value, Parse parse,
                     const std::string& help)
{
	const std::function<Status(const std::string&)> set = [&value, parse](const std::string& word) -> Status
	{
		auto read = parse(word);
		if (!read)
			return read.error();
		value = std::move(*read);
		return Nothing{};
	};
	return addText(command, options, name, set, help);
}

// Adds an option that takes one of a few words. CLI11 refuses other words.
template <class T>
CLI::Option* addWord(CLI::App& command, const char* name, T& value, const std::string& help)
{
	if constexpr (view::Named<T>)
		return command
		    .add_option_function<std::string>(
		        name, [&value](const std::string& word) { value = *view::parse<T>(word); }, help)
		    ->check(CLI::IsMember(view::wordsOf<T>()))
		    ->default_str(view::text(value));
	else // an optional one
		return command
		    .add_option_function<std::string>(
		        name, [&value](const std::string& word) { value = *view::parse<typename T::value_type>(word); }, help)
		    ->check(CLI::IsMember(view::wordsOf<typename T::value_type>()));
}

// Adds an option that takes `count` numbers. `make` turns them into the value.
template <class T, class Make>
CLI::Option* addNumbers(CLI::App& command, const char* name, int count, std::optional<T>& value, Make make,
                        const std::string& help)
{
	return command
	    .add_option_function<std::vector<double>>(
	        name, [&value, make](const std::vector<double>& numbers) { value = make(numbers); }, help)
	    ->expected(count)
	    ->allow_extra_args(false);
}

inline Vec3 vectorOf(const std::vector<double>& numbers)
{
	return {numbers[0], numbers[1], numbers[2]};
}

template <class T>
T pairOf(const std::vector<double>& numbers)
{
	return T{numbers[0], numbers[1]};
}

} // namespace vp::app
