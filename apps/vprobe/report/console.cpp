#include "report/console.h"

#include <algorithm>
#include <cstdio>

namespace vp::app
{

namespace
{

std::string program_name = "vprobe";

// A key of settings: what else stands between backquotes, as a part of a file's name, is none.
bool isKey(std::string_view text)
{
	return !text.empty() && text.front() >= 'a' && text.front() <= 'z' &&
	       std::ranges::all_of(text, [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; });
}

} // namespace

std::string withOptionNames(std::string_view message)
{
	std::string text;
	for (;;)
	{
		const std::size_t begin = message.find('`');
		const std::size_t end = begin == message.npos ? message.npos : message.find('`', begin + 1);
		if (end == message.npos)
			return text.append(message);
		const std::string_view key = message.substr(begin + 1, end - begin - 1);
		if (isKey(key))
		{
			text.append(message.substr(0, begin)).append("--").append(key);
			std::replace(text.end() - static_cast<std::ptrdiff_t>(key.size()), text.end(), '_', '-');
			message.remove_prefix(end + 1);
		}
		else
		{
			text.append(message.substr(0, end)); // the second one may begin a key
			message.remove_prefix(end);
		}
	}
}

void setProgramName(std::string name)
{
	program_name = std::move(name);
}

void printLine(std::string_view line)
{
	// Standard error has no buffer: one write.
	fmt::print(stderr, "{}: {}\n", program_name, withOptionNames(line));
}

} // namespace vp::app
