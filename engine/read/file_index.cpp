#include "read/file_index.h"

#include "base/messages.h"
#include "read/source_stamp.h"

#include <atomic>
#include <cstdlib>
#include <string_view>

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

std::string indexOf(const std::string& file, const ReadOptions& options)
{
	const bool reads_as_it_is = options.format.empty() && options.raw == RawLayout{} && options.solution.empty() &&
	                            options.slices.empty() && options.displace == 0.0 && options.level == 0;
	if (!indicesAreUsed() || !options.keeps_in_runs || !reads_as_it_is)
		return {};
	std::string index = file + std::string(kIndexEnding);
	struct stat of_index = {}, of_file = {};
	if (stat(index.c_str(), &of_index) != 0 || !S_ISREG(of_index.st_mode) || stat(file.c_str(), &of_file) != 0)
		return {};
	// Whoever writes an index says what figures are.
	if (of_index.st_uid == geteuid() || of_index.st_uid == of_file.st_uid || of_index.st_uid == 0)
		return index;
	warn("{}: it belongs to another user and is not used; run vprobe index {}", index, file);
	return {};
}

} // namespace vp::read
