#pragma once

#include <cstdio>
#include <optional>
#include <string>

namespace vp::bench
{

// Runs a shell command. Returns what it writes to standard output; nothing if it fails.
inline std::optional<std::string> outputOf(const std::string& command)
{
	std::FILE* pipe = ::popen(command.c_str(), "r");
	if (!pipe)
		return std::nullopt;
	std::string text;
	char part[4096];
	while (const std::size_t read = std::fread(part, 1, sizeof(part), pipe))
		text.append(part, read);
	if (::pclose(pipe) != 0)
		return std::nullopt;
	return text;
}

} // namespace vp::bench
