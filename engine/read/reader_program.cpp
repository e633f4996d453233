#include "read/child.h"

#include <filesystem>

#include <fmt/format.h>

#include <unistd.h>

namespace vp::read
{

namespace
{
std::string override_path;
}

void setReaderProgram(std::string path)
{
	override_path = std::move(path);
}

Result<std::string> readerProgram()
{
	namespace fs = std::filesystem;
	if (!override_path.empty())
		return override_path;
	std::error_code error;
	const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
	for (const fs::path& candidate :
	     {folder / "vprobe-read", folder.parent_path() / "libexec" / "vprobe" / "vprobe-read"})
		if (access(candidate.c_str(), X_OK) == 0)
			return candidate.string();
	return Error{
	    ErrorKind::internal,
	    fmt::format("vprobe-read is missing from {} and ../libexec/vprobe; install it beside vprobe", folder.string())};
}

} // namespace vp::read
