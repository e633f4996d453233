#include "base/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <mutex>
#include <utility>

namespace vp
{

namespace
{
spdlog::logger& logger()
{
	static const auto log = []
	{
		auto made = spdlog::stderr_logger_mt("vprobe");
		made->set_pattern("%n: %v");
		return made;
	}();
	return *log;
}

struct Listening
{
	std::mutex mutex;
	std::function<void(std::string_view)> hear;
};

Listening& listening()
{
	static Listening one;
	return one;
}
} // namespace

WarningListener::WarningListener(std::function<void(std::string_view)> hear)
{
	const std::lock_guard lock(listening().mutex);
	listening().hear = std::move(hear);
}

WarningListener::~WarningListener()
{
	const std::lock_guard lock(listening().mutex);
	listening().hear = nullptr;
}

void logWarning(std::string_view line)
{
	{
		const std::lock_guard lock(listening().mutex);
		if (listening().hear)
			return listening().hear(line);
	}
	logger().warn(line);
}

void logError(std::string_view line)
{
	logger().error(line);
}

} // namespace vp
