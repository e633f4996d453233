#include "read/file_index.h"

#include "base/messages.h"
#include "base/user_folder.h"
#include "read/source_stamp.h"

#include <fmt/format.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace vp::read
{

namespace
{

std::atomic<bool>& indicesAreUsed()
{
	static std::atomic<bool> used = []
	{
		const char* set = std::getenv("VPROBE_INDEX");
		const std::string_view word = set ? set : "on";
		if (word != "on" && word != "off" && !word.empty())
			warn("VPROBE_INDEX must be on or off, not {}; indices are used", word);
		return word != "off";
	}();
	return used;
}

} // namespace

void setUsesIndices(bool uses)
{
	indicesAreUsed() = uses;
}

std::string indexBeside(const std::string& file)
{
	return file + std::string(kIndexEnding);
}

std::string indexInCache(const std::string& file)
{
	namespace fs = std::filesystem;
	std::error_code failed;
	const fs::path folder = userFolder("XDG_CACHE_HOME", ".cache"), path = fs::canonical(file, failed);
	if (folder.empty() || failed)
		return {};
	// Files of one name lie in different folders. If two have one hash all the same, the stamp tells.
	std::uint64_t hash = 0xcbf29ce484222325; // FNV-1a of 64 bits
	for (const unsigned char byte : path.string())
		hash = (hash ^ byte) * 0x100000001b3;
	return folder / fmt::format("{}-{:016x}{}", path.filename().string(), hash, kIndexEnding);
}

std::string indexOf(const std::string& file, const ReadOptions& options)
{
	const bool reads_as_it_is = options.format.empty() && options.raw == RawLayout{} && options.solution.empty() &&
	                            options.slices.empty() && options.displace == 0.0 && options.level == 0;
	if (!indicesAreUsed() || !options.keeps_in_runs || !reads_as_it_is)
		return {};
	struct stat of_index = {}, of_file = {};
	const auto isThere = [&of_index](const std::string& index)
	{ return !index.empty() && stat(index.c_str(), &of_index) == 0 && S_ISREG(of_index.st_mode); };
	std::string index = indexBeside(file);
	if (!isThere(index))
		index = indexInCache(file);
	if (!isThere(index))
		return {};
	if (stat(file.c_str(), &of_file) != 0)
		return {};
	// Whoever writes an index says what figures are.
	if (of_index.st_uid == geteuid() || of_index.st_uid == of_file.st_uid || of_index.st_uid == 0)
		return index;
	warn("{}: it belongs to another user and is not used; run vprobe index {}", index, file);
	return {};
}

} // namespace vp::read
