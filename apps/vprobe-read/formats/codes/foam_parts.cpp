#include "foam_parts.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

namespace vp::reader::codes
{

namespace fs = std::filesystem;

namespace
{

constexpr std::size_t kMaxParts = 1 << 20;

// Takes a number off the front of a name.
std::optional<std::size_t> takeNumber(std::string_view& name)
{
	std::size_t number = 0;
	const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
	if (error != std::errc() || number >= kMaxParts)
		return std::nullopt;
	name.remove_prefix(static_cast<std::size_t>(end - name.data()));
	return number;
}

bool takeMark(std::string_view& name, std::string_view mark)
{
	if (!name.starts_with(mark))
		return false;
	name.remove_prefix(mark.size());
	return true;
}

// The processors whose files lie in one folder.
struct Folder
{
	std::size_t all = 0; // processors of the decomposition; 0 for a folder of one processor
	std::size_t first = 0, last = 0;
};

// The folder is "processor3", or "processors4" or "processors4_0-1" if processors share their files.
std::optional<Folder> folderOf(std::string_view name)
{
	if (!takeMark(name, "processor"))
		return std::nullopt;
	Folder folder;
	const bool is_shared = takeMark(name, "s");
	const std::optional<std::size_t> number = takeNumber(name);
	if (!number || (is_shared && *number == 0))
		return std::nullopt;
	folder.first = folder.last = *number;
	if (is_shared)
	{
		folder = {*number, 0, *number - 1};
		if (takeMark(name, "_"))
		{
			const auto first = takeNumber(name);
			const auto last = takeMark(name, "-") ? takeNumber(name) : std::nullopt;
			if (!first || !last || *first > *last || *last >= folder.all)
				return std::nullopt;
			folder.first = *first;
			folder.last = *last;
		}
	}
	return name.empty() ? std::optional(folder) : std::nullopt;
}

// One way in which the case was decomposed.
struct Decomposition
{
	std::map<std::size_t, FoamPlace> places; // by the processor
	std::set<fs::path> folders;
};

std::map<std::size_t, Decomposition> decompositionsIn(const fs::path& folder)
{
	std::map<std::size_t, Decomposition> found;
	std::error_code none;
	for (const auto& entry : fs::directory_iterator(folder, none))
	{
		const std::optional<Folder> part = folderOf(entry.path().filename().string());
		if (!part || !entry.is_directory(none))
			continue;
		Decomposition& decomposition = found[part->all];
		decomposition.folders.insert(entry.path());
		for (std::size_t p = part->first; p <= part->last; ++p)
		{
			FoamPlace place = {entry.path()};
			if (part->all > 0)
				place.block = p - part->first;
			decomposition.places.try_emplace(p, std::move(place));
		}
	}
	return found;
}

FoamParts partsOf(const Decomposition& decomposition, std::size_t all)
{
	FoamParts parts;
	for (const auto& [number, place] : decomposition.places)
	{
		if (number != parts.places.size())
			break;
		parts.places.push_back(place);
	}
	if (parts.places.size() != std::max(decomposition.places.size(), all))
		parts.missing = parts.places.size();
	std::map<std::string, std::size_t> folders; // that have a time
	std::map<std::string, double> values;
	for (const fs::path& folder : decomposition.folders)
		for (const FoamTime& time : foamTimes(folder))
		{
			++folders[time.name];
			values.emplace(time.name, time.value);
		}
	for (const auto& [name, count] : folders)
		if (count == decomposition.folders.size())
			parts.times.push_back({name, values.at(name)});
		else
			++parts.unfinished;
	std::ranges::sort(parts.times, {}, [](const FoamTime& time) { return std::pair(time.value, time.name); });
	return parts;
}

} // namespace

FoamParts foamParts(const fs::path& folder)
{
	FoamParts latest;
	for (const auto& [all, decomposition] : decompositionsIn(folder))
	{
		FoamParts parts = partsOf(decomposition, all);
		if ((latest.places.empty() && !latest.missing) || lastFoamTime(parts.times) > lastFoamTime(latest.times))
			latest = std::move(parts);
	}
	return latest;
}

} // namespace vp::reader::codes
