#pragma once

#include <fmt/format.h>

#include <string_view>

namespace vp
{

// Words for the user, one line each on standard error; standard output belongs to results.
void logWarning(std::string_view line);
void logError(std::string_view line);

template <class... Args>
void warn(fmt::format_string<Args...> format, Args&&... args)
{
	logWarning(fmt::format(format, std::forward<Args>(args)...));
}

} // namespace vp
