#include "arguments.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

namespace vp::app
{

namespace
{

struct Folded
{
	std::string_view option;
	int numbers; // at most
};
constexpr std::array<Folded, 2> kFolded{{{"--normal", 3}, {"--camera", 9}}};

bool isNumber(const std::string& text)
{
	char* end = nullptr;
	std::strtod(text.c_str(), &end);
	return !text.empty() && *end == '\0';
}

} // namespace

std::vector<std::string> foldNumbers(int argc, const char* const* argv)
{
	std::vector<std::string> arguments;
	for (int i = 1; i < argc; ++i)
	{
		const std::string argument = argv[i];
		const auto folded =
		    std::find_if(kFolded.begin(), kFolded.end(), [&](const Folded& f) { return f.option == argument; });
		if (folded == kFolded.end() || i + 1 == argc || std::string_view(argv[i + 1]).starts_with("--"))
		{
			arguments.push_back(argument);
			continue;
		}
		std::string values = argv[++i];
		if (isNumber(values))
			for (int taken = 1; taken < folded->numbers && i + 1 < argc && isNumber(argv[i + 1]); ++taken)
				values += std::string(" ") + argv[++i];
		arguments.push_back(argument + "=" + values);
	}
	std::reverse(arguments.begin(), arguments.end());
	return arguments;
}

} // namespace vp::app
