#include "base/progress.h"

#include <mutex>
#include <utility>

namespace vp
{

namespace
{

struct ProgressListening
{
	std::mutex mutex;
	ProgressSink sink;
};

ProgressListening& progressListening()
{
	static ProgressListening one;
	return one;
}

} // namespace

ProgressListener::ProgressListener(ProgressSink sink)
{
	const std::lock_guard lock(progressListening().mutex);
	previous_ = std::exchange(progressListening().sink, std::move(sink));
}

ProgressListener::~ProgressListener()
{
	const std::lock_guard lock(progressListening().mutex);
	progressListening().sink = std::move(previous_);
}

void Progress::say(std::string_view what)
{
	const std::lock_guard lock(progressListening().mutex);
	if (progressListening().sink)
		progressListening().sink(what);
}

} // namespace vp
