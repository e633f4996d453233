#include "write/own_folder.h"

#include "write/atomic_file.h"
#include "write/unfinished.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

namespace vp::write
{

Result<OwnFolder> OwnFolder::besideFile(const std::string& file)
{
	const TouchingFiles files;
	std::string folder = nearestFolder(file) + "/.vprobe-XXXXXX";
	if (!mkdtemp(folder.data()))
		return Error{ErrorKind::output, fmt::format("{}: no folder can be made beside it ({}); choose another place",
		                                            file, std::strerror(errno))};
	rememberUnfinished(folder);
	return OwnFolder(std::move(folder));
}

OwnFolder::OwnFolder(OwnFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}

OwnFolder::~OwnFolder()
{
	if (path_.empty())
		return;
	std::error_code ignored;
	std::filesystem::remove_all(path_, ignored);
	forgetUnfinished(path_);
}

} // namespace vp::write
