#include "options/trace_option.h"

#include "team.h"

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

} // namespace vp::app
