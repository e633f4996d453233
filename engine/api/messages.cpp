#include "base/messages.h"
#include "base/idle_threads.h"
#include "base/progress.h"
#include "version.h"

#include <vprobe/result.h>
#include <vprobe/vprobe.h>

namespace vprobe
{

struct MessageListener::State
{
	vp::MessageListener listener;
};

MessageListener::MessageListener(std::function<void(std::string_view)> sink)
    : state_(
          new State{vp::MessageListener([sink = std::move(sink)](vp::Severity, std::string_view line) { sink(line); })})
{
}

MessageListener::~MessageListener() = default;

struct ProgressListener::State
{
	vp::ProgressListener listener;
};

ProgressListener::ProgressListener(std::function<void(std::string_view)> sink)
    : state_(new State{vp::ProgressListener(std::move(sink))})
{
}

ProgressListener::~ProgressListener() = default;

const char* version()
{
	return kVersion;
}

bool endIdleThreads()
{
	return vp::endIdleThreads();
}

} // namespace vprobe
