#include "base/input_files.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>

#include <sys/stat.h>

namespace vp
{

namespace
{

using Identity = std::pair<dev_t, ino_t>;

struct InputFiles
{
	std::mutex mutex;
	std::unordered_map<std::string, InputKind> by_place; // without links
	std::map<Identity, std::string> by_identity;         // the place where a file was read
};

InputFiles& inputFiles()
{
	static InputFiles one;
	return one;
}

std::optional<Identity> identityOf(const std::string& path)
{
	struct stat about = {};
	if (stat(path.c_str(), &about) != 0 || !S_ISREG(about.st_mode))
		return std::nullopt;
	return Identity{about.st_dev, about.st_ino};
}

std::string placeOf(const std::string& path)
{
	const std::unique_ptr<char, decltype(&std::free)> place(realpath(path.c_str(), nullptr), &std::free);
	return place ? std::string(place.get()) : path;
}

} // namespace

void noteInput(const std::string& path, InputKind kind)
{
	const std::optional<Identity> identity = identityOf(path);
	if (!identity)
		return;
	const std::string place = placeOf(path);
	InputFiles& files = inputFiles();
	const std::lock_guard lock(files.mutex);
	const auto [known, is_new] = files.by_place.try_emplace(place, kind);
	known->second = std::min(known->second, kind);
	files.by_identity[*identity] = place;
}

std::optional<InputKind> inputAt(const std::string& path)
{
	const std::optional<Identity> identity = identityOf(path);
	if (!identity)
		return std::nullopt; // nothing is there, so nothing is lost
	InputFiles& files = inputFiles();
	const std::lock_guard lock(files.mutex);
	if (const auto known = files.by_place.find(placeOf(path)); known != files.by_place.end())
		return known->second;
	const auto same = files.by_identity.find(*identity);
	// Numbers of files that are gone are given out again, so the place is asked once more.
	if (same == files.by_identity.end() || identityOf(same->second) != identity)
		return std::nullopt;
	return files.by_place.at(same->second);
}

} // namespace vp
