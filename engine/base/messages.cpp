#include "base/messages.h"

#include <mutex>
#include <utility>

namespace vp
{

namespace
{

struct Listening
{
	std::mutex mutex;
	MessageSink sink;
};

Listening& listening()
{
	static Listening one;
	return one;
}

} // namespace

MessageListener::MessageListener(MessageSink sink)
{
	const std::lock_guard lock(listening().mutex);
	previous_ = std::exchange(listening().sink, std::move(sink));
}

MessageListener::~MessageListener()
{
	const std::lock_guard lock(listening().mutex);
	listening().sink = std::move(previous_);
}

void report(Severity severity, std::string_view line)
{
	const std::lock_guard lock(listening().mutex);
	if (listening().sink)
		listening().sink(severity, line);
}

} // namespace vp
