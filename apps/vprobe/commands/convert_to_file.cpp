#include "commands/convert_to_file.h"

#include "read/convert.h"
#include "write/atomic_file.h"
#include "write/own_folder.h"

#include <fmt/format.h>

#include <filesystem>

namespace vp::app
{

namespace fs = std::filesystem;

void addPartSize(CLI::App& command, int& part)
{
	command
	    .add_option("--part", part, fmt::format("Cells of a part of an unstructured grid, at most ({})", kUsualPart))
	    ->type_name("CELLS")
	    ->check(CLI::Range(64, 1 << 24));
}

Status convertToFile(const std::string& input, const read::ReadOptions& reading, const std::string& output)
{
	Result<write::AtomicFile> out = write::AtomicFile::create(output);
	if (!out)
		return out.error();
	if (out->beside().empty())
		return Error{ErrorKind::usage, fmt::format("-o {}: a device or pipe; name a file", output)};
	const Result<write::OwnFolder> folder = write::OwnFolder::besideFile(output);
	if (!folder)
		return folder.error();
	if (Status done = read::convert(input, reading, output, folder->path()); !done)
		return done;
	if (Status taken = out->take((fs::path(folder->path()) / fs::path(output).filename()).string()); !taken)
		return taken;
	return out->commit();
}

} // namespace vp::app
