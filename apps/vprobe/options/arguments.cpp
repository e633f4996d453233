#include "options/arguments.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace vp::app
{

namespace
{

std::vector<std::string> command_line;

} // namespace

const std::vector<std::string>& commandLine()
{
	return command_line;
}

void setCommandLine(std::vector<std::string> arguments)
{
	command_line = std::move(arguments);
}

std::vector<std::string> joinNumbers(const std::vector<std::string>& given)
{
	static const std::map<std::string, std::ptrdiff_t> most{{"--normal", 3}, {"--camera", 9}};
	std::vector<std::string> arguments;
	for (auto argument = given.begin(); argument != given.end();)
	{
		arguments.push_back(*argument++);
		const auto option = most.find(arguments.back());
		if (option == most.end())
			continue;
		const auto end = std::next(argument, std::min(option->second, std::distance(argument, given.end())));
		const auto words = std::find_if(argument, end, [](const std::string& s) { return !CLI::Number(s).empty(); });
		if (words == argument)
			continue;
		arguments.push_back(CLI::detail::join(std::vector(argument, words), " "));
		argument = words;
	}
	std::reverse(arguments.begin(), arguments.end());
	return arguments;
}

} // namespace vp::app
