#include "options/trace_option.h"

#include "gpu/driver_name.h"
#include "options/arguments.h"
#include "team.h"
#include "version.h"

#include <fmt/ranges.h>
#include <tbb/global_control.h>

namespace vp::app
{

void addTraceOption(CLI::App& command, std::string& path, const char* group)
{
	command
	    .add_option("--trace", path,
	                "Write every section of work on one time axis, for chrome://tracing or ui.perfetto.dev")
	    ->type_name("FILE.json|-")
	    ->group(group);
}

Result<std::optional<write::TraceFile>> openTrace(const std::string& path)
{
	if (path.empty() || !isFirst()) // of several processes the first tells its own work
		return std::optional<write::TraceFile>();
	Result<write::TraceFile> file = write::TraceFile::create(path);
	if (!file)
		return file.error();
	return std::optional(std::move(*file));
}

void addToTrace(const session::Session& session, write::TraceFile& trace)
{
	Timeline& timeline = *session.timeline();
	std::vector<Timeline::Section> sections = timeline.takeSections();
	trace.add(std::move(sections), timeline.takeMarks());
}

void describeTrace(write::TraceFile& trace, const std::vector<std::string>& inputs, const std::string& device,
                   const std::string& driver)
{
	trace.describe("program", fmt::format("vprobe {}", kVersion));
	trace.describe("command_line", fmt::format("{}", fmt::join(commandLine(), " ")));
	trace.describe("input", fmt::format("{}", fmt::join(inputs, ", ")));
	trace.describe("device", device);
	trace.describe("driver", driver);
	trace.describe("threads",
	               fmt::format("{}", tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)));
}

Status commitTrace(const session::Session& session, write::TraceFile& trace)
{
	const gpu::Device* device = session.device().get();
	describeTrace(trace, session.spec().input.files, device ? device->name() : "none",
	              device ? gpu::driverName(*device) : "none");
	return trace.commit();
}

} // namespace vp::app
