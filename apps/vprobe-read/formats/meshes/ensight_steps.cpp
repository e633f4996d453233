// Which step of an EnSight case is shown at a time, and in which file it lies.
#include "ensight_case.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace vp::reader::meshes
{

namespace
{

bool hasAsterisk(const EnSightCase::Files& files)
{
	return std::ranges::any_of(files.names, [](const std::string& name) { return name.find('*') != name.npos; });
}

// Each group of asterisks becomes the number, with zeros in front.
std::string numbered(std::string name, std::int64_t number)
{
	for (auto star = name.find('*'); star != name.npos; star = name.find('*', star))
	{
		const auto width = std::min(name.find_first_not_of('*', star), name.size()) - star;
		name.replace(star, width, fmt::format("{:0{}}", number, width));
	}
	return name;
}

} // namespace

const EnSightCase::TimeSet* timeSetOf(const EnSightCase& about, const EnSightCase::Files& files)
{
	std::optional<std::int64_t> number = files.time_set;
	if (!number && (hasAsterisk(files) || files.file_set) && !about.time_sets.empty())
		number = about.time_sets.begin()->first;
	if (!number)
		return nullptr;
	const auto found = about.time_sets.find(*number);
	if (found == about.time_sets.end() || found->second.times.empty())
	{
		if (hasAsterisk(files))
			throw damaged(fmt::format("it has no times in the time set {} of {}", *number, files.names[0]));
		return nullptr;
	}
	return &found->second;
}

std::vector<double> timesOf(const EnSightCase& about)
{
	std::set<const EnSightCase::TimeSet*> used = {timeSetOf(about, about.model)};
	for (const EnSightCase::Variable& variable : about.variables)
		used.insert(timeSetOf(about, variable.files));
	used.erase(nullptr);
	if (used.empty())
		for (const auto& [number, set] : about.time_sets)
			used.insert(&set);
	std::map<double, std::size_t> counts;
	for (const EnSightCase::TimeSet* set : used)
	{
		std::map<double, std::size_t> own;
		for (const double time : set->times)
			counts[time] = std::max(counts[time], ++own[time]);
	}
	std::vector<double> times;
	for (const auto& [time, count] : counts)
		times.insert(times.end(), count, time);
	return times;
}

std::size_t stepAt(const EnSightCase::TimeSet& set, const EnSightTime& time, bool& is_before)
{
	const std::vector<double>& times = set.times;
	double latest = -std::numeric_limits<double>::infinity();
	for (const double each : times)
		if (each <= time.time)
			latest = std::max(latest, each);
	is_before = !std::isfinite(latest);
	if (is_before)
		return static_cast<std::size_t>(std::ranges::min_element(times) - times.begin());
	// Among equal times, takes the one that is asked for, or the last one.
	std::size_t step = 0, seen = 0;
	for (std::size_t i = 0; i < times.size(); ++i)
		if (times[i] == latest && (seen == 0 || latest < time.time || seen <= time.occurrence))
		{
			step = i;
			++seen;
		}
	return step;
}

EnSightPlace placeOf(const EnSightCase& about, const EnSightCase::Files& files, std::size_t which, std::size_t step)
{
	const std::string& name = files.names[which];
	const EnSightCase::TimeSet* times = timeSetOf(about, files);
	const auto set = files.file_set ? about.file_sets.find(*files.file_set) : about.file_sets.end();
	if (set != about.file_sets.end())
	{
		std::size_t before = 0;
		for (const EnSightCase::FileSet::File& file : set->second.files)
		{
			if (step - before < file.steps)
			{
				if (name.find('*') != name.npos && !file.number)
					break; // one file for each step
				return {file.number ? numbered(name, *file.number) : name, step - before, file.steps > 1};
			}
			before += file.steps;
		}
		if (step >= before && before > 0)
			throw damaged(
			    fmt::format("its file set {} has {} steps, fewer than its time set", *files.file_set, before));
	}
	if (name.find('*') == name.npos)
		return {name, step, false};
	if (!times || step >= times->numbers.size())
		throw damaged(fmt::format("it has no number for the asterisks of {}", name));
	return {numbered(name, times->numbers[step]), 0, false};
}

} // namespace vp::reader::meshes
