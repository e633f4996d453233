#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <functional>
#include <string_view>

namespace vp
{

enum class Severity : std::uint8_t
{
	note,    // tells how something was understood
	warning, // the call continues, but the result may not be what was meant
	error    // a message of Vulkan's validation, when debugging
};

/// Receives messages for people: one line each, without a line break. Settings stand between backquotes, see Error.
using MessageSink = std::function<void(Severity, std::string_view)>;

/// While one lives, messages go to its sink, from any thread, one at a time. The youngest one hears; without one,
/// messages are dropped: a library writes to nobody's screen. Listeners end in the reverse order of their beginning.
class MessageListener
{
public:
	explicit MessageListener(MessageSink sink);
	~MessageListener();
	MessageListener(const MessageListener&) = delete;
	MessageListener& operator=(const MessageListener&) = delete;

private:
	MessageSink previous_;
};

void report(Severity severity, std::string_view line);

template <class... Args>
void note(fmt::format_string<Args...> format, Args&&... args)
{
	report(Severity::note, fmt::format(format, std::forward<Args>(args)...));
}

template <class... Args>
void warn(fmt::format_string<Args...> format, Args&&... args)
{
	report(Severity::warning, fmt::format(format, std::forward<Args>(args)...));
}

} // namespace vp
