#include "options/first_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <numeric>

namespace vp::app
{

namespace
{

// Returns the least number of letters to add, remove or replace, where two neighbors that change places count once.
std::size_t lettersApart(const std::string& a, const std::string& b)
{
	std::vector<std::vector<std::size_t>> apart(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
	for (std::size_t i = 0; i <= a.size(); ++i)
		for (std::size_t j = 0; j <= b.size(); ++j)
		{
			std::size_t& here = apart[i][j];
			if (i == 0 || j == 0)
			{
				here = i + j;
				continue;
			}
			here = std::min({apart[i - 1][j] + 1, apart[i][j - 1] + 1, apart[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
			if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
				here = std::min(here, apart[i - 2][j - 2] + 1);
		}
	return apart.back().back();
}

bool isInput(const std::string& word)
{
	std::error_code unknown;
	return word.find_first_of("./") != word.npos || word.starts_with("demo:") || std::filesystem::exists(word, unknown);
}

bool hasDisplay()
{
	for (const char* name : {"WAYLAND_DISPLAY", "DISPLAY"})
		if (const char* display = std::getenv(name); display && *display)
			return true;
	return false;
}

} // namespace

std::string nearestWord(const std::string& word, const std::vector<std::string>& words)
{
	std::string nearest;
	std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
	for (const std::string& known : words)
		if (const std::size_t apart = lettersApart(word, known); apart < least)
		{
			least = apart;
			nearest = known;
		}
	return nearest;
}

Result<std::vector<std::string>> withCommand(std::vector<std::string> arguments,
                                             const std::vector<std::string>& commands, bool opens_files)
{
	if (arguments.empty() || arguments[0].starts_with('-') ||
	    std::find(commands.begin(), commands.end(), arguments[0]) != commands.end())
		return arguments;
	const std::string first = arguments[0];
	if (!opens_files || !isInput(first))
	{
		const std::string nearest = nearestWord(first, commands);
		return Error{ErrorKind::usage, fmt::format("{}: no such command{}", first,
		                                           nearest.empty() ? "" : fmt::format("; {} is one", nearest))};
	}
	arguments.insert(arguments.begin(), hasDisplay() ? "view" : "render"); // which chooses a name for the picture
	return arguments;
}

} // namespace vp::app
