#include "read_files.h"

#include "read/protocol.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <string_view>
#include <unordered_set>

#include <sys/stat.h>
#include <unistd.h>

namespace vp::reader
{

namespace fs = std::filesystem;

namespace
{

struct FilesRead
{
	std::mutex mutex;
	std::unordered_set<std::string> known;
	std::vector<std::string> in_order;
	std::vector<std::string> refused;
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

// Returns true for files in which libraries look for settings: hidden ones, and those in hidden folders.
bool isOfSettings(const fs::path& path)
{
	const auto isHidden = [](const std::string& name) { return name.starts_with('.') && name != "." && name != ".."; };
	return isHidden(path.filename().string()) || isHidden(path.parent_path().filename().string());
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
	std::string line = std::string(read::kReadingMark) + path;
	std::replace(line.begin(), line.end(), '\n', ' ');
	line += '\n';
	if (write(STDERR_FILENO, line.data(), line.size()) < 0)
		return; // the parent is gone
}

void noteRefused(const char* path)
{
	constexpr std::size_t most = 4;
	// The sandbox refuses to open files, but tells of them, and of the user's rights to them.
	if (looking > 0 || !path || isOfTheSystem(path) || isOfSettings(path) || access(path, R_OK) != 0)
		return;
	FilesRead& files = filesOfThis();
	const std::lock_guard lock(files.mutex);
	if (files.tells && files.refused.size() < most && std::ranges::find(files.refused, path) == files.refused.end())
		files.refused.emplace_back(path);
}

std::vector<std::string> refusedFiles()
{
	FilesRead& files = filesOfThis();
	const std::lock_guard lock(files.mutex);
	std::vector<std::string> lines;
	for (const std::string& path : files.refused)
	{
		std::error_code error;
		const fs::path real = fs::canonical(path, error);
		lines.push_back(fmt::format("names the file {}, which the reader's sandbox does not open; if you trust the "
		                            "input, give --follow {}",
		                            path, (error ? fs::absolute(path, error) : real).parent_path().string()));
	}
	return lines;
}

bool isNoFile(const char* path)
{
	struct stat about = {};
	return path && !isOfTheSystem(path) && stat(path, &about) == 0 && !S_ISREG(about.st_mode) &&
	       !S_ISDIR(about.st_mode);
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

} // namespace vp::reader
