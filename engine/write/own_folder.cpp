#include "write/own_folder.h"

#include "write/atomic_file.h"
#include "write/held_name.h"
#include "write/unfinished.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vp::write
{

Result<OwnFolder> OwnFolder::besideFile(const std::string& file)
{
	const std::string beside = nearestFolder(file);
	removeLeftovers(beside);
	const TouchingFiles files;
	for (;;)
	{
		std::string folder = newHeldName(beside);
		if (mkdir(folder.c_str(), 0700) != 0)
		{
			if (errno == EEXIST)
				continue;
			return Error{ErrorKind::output,
			             fmt::format("{}: no folder can be made beside it ({}); choose another place", file,
			                         std::strerror(errno))};
		}
		const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
		if (descriptor >= 0 && holdName(descriptor))
		{
			rememberUnfinished(folder);
			return OwnFolder(std::move(folder), descriptor);
		}
		if (descriptor >= 0)
			close(descriptor);
	}
}

OwnFolder::OwnFolder(OwnFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), descriptor_(std::exchange(other.descriptor_, -1))
{
}

OwnFolder::~OwnFolder()
{
	if (path_.empty())
		return;
	std::error_code ignored;
	std::filesystem::remove_all(path_, ignored);
	forgetUnfinished(path_);
	close(descriptor_);
}

} // namespace vp::write
