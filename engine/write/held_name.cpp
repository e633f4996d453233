#include "write/held_name.h"

#include "write/unfinished.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <set>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vp::write
{

namespace
{

// Other machines may use the same folder, and their locks need not be seen here. The machine's name ends at the next
// "-", so none begins with another one.
const std::string& beginningOfNames()
{
	static const std::string beginning = []
	{
		std::array<char, 64> host = {};
		gethostname(host.data(), host.size() - 1);
		std::string name = host.data();
		for (char& c : name)
			if (!std::isalnum(static_cast<unsigned char>(c)))
				c = '_';
		return ".vprobe-" + name.substr(0, 40) + "-";
	}();
	return beginning;
}

// Removes a file or folder unless somebody holds it.
void removeIfLeft(const std::filesystem::path& path)
{
	const int left = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
	if (left < 0)
		return;
	struct stat about = {};
	std::error_code ignored;
	if (fstat(left, &about) == 0 && about.st_uid == geteuid() && (S_ISREG(about.st_mode) || S_ISDIR(about.st_mode)) &&
	    flock(left, LOCK_EX | LOCK_NB) == 0)
		std::filesystem::remove_all(path, ignored);
	close(left);
}

} // namespace

std::string newHeldName(const std::string& folder)
{
	static std::atomic<unsigned> counter = 0;
	return fmt::format("{}/{}{}-{}", folder, beginningOfNames(), getpid(), counter++);
}

bool holdName(int descriptor)
{
	if (flock(descriptor, LOCK_EX | LOCK_NB) != 0)
		return errno != EWOULDBLOCK; // some file systems have no locks, and nothing is removed there
	struct stat about = {};
	return fstat(descriptor, &about) != 0 || about.st_nlink > 0;
}

void removeLeftovers(const std::string& folder)
{
	static std::mutex mutex;
	static std::set<std::string> seen;
	const std::lock_guard lock(mutex);
	if (!seen.insert(folder).second)
		return;
	const TouchingFiles files;
	std::error_code failed;
	for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end;
	     entry.increment(failed))
		if (entry->path().filename().native().starts_with(beginningOfNames()))
			removeIfLeft(entry->path());
}

} // namespace vp::write
