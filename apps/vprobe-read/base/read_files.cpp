#include "read_files.h"

#include "read/protocol.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <string_view>
#include <unordered_set>

#include <sys/stat.h>
#include <unistd.h>

namespace
{

struct FilesRead
{
	std::mutex mutex;
	std::unordered_set<std::string> known;
	std::vector<std::string> in_order;
	std::string input;
	std::string last;
	bool tells = false;
};

// The object is never destroyed, since files are opened until the process ends.
FilesRead& filesOfThis()
{
	static auto& one = *new FilesRead;
	return one;
}

std::atomic<int> looking = 0;

// Returns true for files that libraries read for themselves.
bool isOfTheSystem(std::string_view path)
{
	constexpr std::array<std::string_view, 6> folders = {"/proc/", "/sys/",    "/dev/",
	                                                     "/etc/",  "/usr/lib", "/usr/share/"};
	return std::ranges::any_of(folders, [&](std::string_view folder) { return path.starts_with(folder); });
}

} // namespace

void tellFiles(const std::string& input)
{
	FilesRead& files = filesOfThis();
	const std::lock_guard lock(files.mutex);
	files.input = input;
	files.tells = true;
}

void noteFile(const char* path)
{
	struct stat about = {};
	if (looking > 0 || !path || isOfTheSystem(path) || stat(path, &about) != 0 || !S_ISREG(about.st_mode))
		return;
	FilesRead& files = filesOfThis();
	const std::lock_guard lock(files.mutex);
	if (!files.tells)
		return;
	if (files.known.insert(path).second)
		files.in_order.emplace_back(path);
	if (files.last == path)
		return;
	files.last = path;
	if (files.last == files.input)
		return;
	std::string line = std::string(vp::read::kReadingMark) + path;
	std::replace(line.begin(), line.end(), '\n', ' ');
	line += '\n';
	if (write(STDERR_FILENO, line.data(), line.size()) < 0)
		return; // the parent is gone
}

std::vector<std::string> filesRead()
{
	FilesRead& files = filesOfThis();
	const std::lock_guard lock(files.mutex);
	return files.in_order;
}

std::string pieceBeingRead()
{
	FilesRead& files = filesOfThis();
	const std::lock_guard lock(files.mutex);
	return files.last == files.input ? std::string() : files.last;
}

void blame(const std::string& piece)
{
	FilesRead& files = filesOfThis();
	const std::lock_guard lock(files.mutex);
	files.last = piece.empty() ? files.input : piece;
}

OnlyLooking::OnlyLooking()
{
	++looking;
}

OnlyLooking::~OnlyLooking()
{
	--looking;
}
