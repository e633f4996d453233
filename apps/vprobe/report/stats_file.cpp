#include "report/stats_json.h"
#include "team.h"
#include "write/atomic_file.h"

#include <filesystem>

namespace vp::app
{

Status checkWritable(const std::string& path)
{
	if (path.empty() || path == "-" || !isFirst())
		return Nothing{};
	const Result<write::AtomicFile> tried = write::AtomicFile::create(path);
	return tried ? Status(Nothing{}) : tried.error();
}

Result<ExitCode> writeStats(const std::string& path, const std::vector<std::string>& outputs,
                            const std::string& document)
{
	if (path.empty() || !isFirst())
		return ExitCode::done;
	Status written = [&]() -> Status
	{
		Result<write::AtomicFile> file = write::AtomicFile::create(path);
		if (!file)
			return file.error();
		file->write(document);
		return file->commit();
	}();
	if (written)
		return ExitCode::done;
	// The file that was written, and not the link that led to it.
	std::error_code unknown;
	for (const std::string& output : outputs)
		if (std::filesystem::is_regular_file(output, unknown))
			std::filesystem::remove(std::filesystem::canonical(output, unknown), unknown);
	return written.error();
}

} // namespace vp::app
