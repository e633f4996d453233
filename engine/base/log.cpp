#include "base/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

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
} // namespace

void logWarning(std::string_view line)
{
	logger().warn(line);
}

void logError(std::string_view line)
{
	logger().error(line);
}

} // namespace vp
