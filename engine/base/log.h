#pragma once

#include <fmt/format.h>

#include <functional>
#include <string_view>

namespace vp
{

// Words for the user, one line each on standard error; standard output belongs to results.
void logWarning(std::string_view line);
void logError(std::string_view line);

// While one lives warnings go to it, from any thread, and not to standard error. One at a time.
class WarningListener
{
public:
	explicit WarningListener(std::function<void(std::string_view)> hear);
	~WarningListener();
	WarningListener(const WarningListener&) = delete;
	WarningListener& operator=(const WarningListener&) = delete;
};

template <class... Args>
void warn(fmt::format_string<Args...> format, Args&&... args)
{
	logWarning(fmt::format(format, std::forward<Args>(args)...));
}

} // namespace vp
