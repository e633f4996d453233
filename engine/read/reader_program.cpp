#include "read/child.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include <dlfcn.h>
#include <unistd.h>

namespace vp::read
{

namespace
{
std::string override_path;
constexpr const char* kProgram = "vprobe-read";
constexpr const char* kInLibexec = "libexec/vprobe/vprobe-read";
} // namespace

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
	std::vector<fs::path> candidates{folder / kProgram, folder.parent_path() / kInLibexec};
	// The reader of a library is beside the library, or in its install prefix, below lib or lib/TRIPLET.
	if (Dl_info info{}; dladdr(reinterpret_cast<const void*>(&setReaderProgram), &info) != 0 && info.dli_fname)
	{
		const fs::path library = fs::absolute(info.dli_fname, error).parent_path();
		candidates.push_back(library / kProgram);
		for (const fs::path& prefix : {library.parent_path(), library.parent_path().parent_path()})
		{
			candidates.push_back(prefix / "bin" / kProgram);
			candidates.push_back(prefix / kInLibexec);
		}
	}
	for (const fs::path& candidate : candidates)
		if (access(candidate.c_str(), X_OK) == 0)
			return candidate.string();
	return Error{
	    ErrorKind::internal,
	    fmt::format("vprobe-read is missing from {} and ../libexec/vprobe; install it beside vprobe", folder.string())};
}

} // namespace vp::read
