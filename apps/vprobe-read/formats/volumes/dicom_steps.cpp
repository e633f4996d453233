#include "dicom_steps.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>

namespace vp::reader::volumes
{

namespace
{

using Frames = std::vector<DicomFrame>;

constexpr double kSamePlace = 1e-4;     // mm
constexpr double kSameDirection = 1e-3; // a tolerance for unit vectors; files write few digits

std::string fileName(const DicomFrame& frame)
{
	return std::filesystem::path(frame.file).filename().string();
}

void keepLargestStack(DicomFrames& all)
{
	std::map<std::string, std::size_t> counts;
	for (const DicomFrame& frame : all.frames)
		++counts[frame.stack];
	if (counts.size() < 2)
		return;
	const auto largest = std::max_element(counts.begin(), counts.end(),
	                                      [](const auto& a, const auto& b) { return a.second < b.second; });
	std::erase_if(all.frames, [&](const DicomFrame& frame) { return frame.stack != largest->first; });
	all.note(fmt::format("the largest of {} stacks is shown, \"{}\" of {} frames; dcm2niix makes a file of each",
	                     counts.size(), largest->first, largest->second));
}

void checkAxes(const std::array<double, 6>& axes)
{
	const double row = std::hypot(axes[0], axes[1], axes[2]);
	const double column = std::hypot(axes[3], axes[4], axes[5]);
	const double across = axes[0] * axes[3] + axes[1] * axes[4] + axes[2] * axes[5];
	if (std::abs(row - 1.0) > 0.01 || std::abs(column - 1.0) > 0.01 || std::abs(across) > 0.01)
		throw damaged("its directions (ImageOrientationPatient) are no right angle of unit vectors");
}

void refuseMixed(const Frames& frames)
{
	const DicomFrame& first = frames[0];
	for (const DicomFrame& frame : frames)
	{
		double turn = 0.0;
		for (std::size_t i = 0; i < 6; ++i)
			turn = std::max(turn, std::abs(frame.axes[i] - first.axes[i]));
		if (turn > kSameDirection)
			throw Refusal(
			    frame.file == first.file
			        ? "its frames lie in several directions; dcm2niix makes a file of each"
			        : fmt::format("{} lies in another direction than the rest of its series; keep the files of "
			                      "one direction in a folder",
			                      fileName(frame)));
		bool is_same = frame.form.columns == first.form.columns && frame.form.rows == first.form.rows &&
		               frame.form.samples == first.form.samples;
		for (std::size_t i = 0; i < 2; ++i)
			is_same = is_same && std::abs(frame.spacing[i] - first.spacing[i]) <= 1e-4 * std::abs(first.spacing[i]);
		if (!is_same)
			throw Refusal(
			    frame.file == first.file
			        ? "its frames have pixels of several sizes"
			        : fmt::format("{} is of another size, or has pixels of another size or kind, than the rest of its "
			                      "series",
			                      fileName(frame)));
	}
}

// Numbers the places by depth. Frames at one depth are in one place.
std::vector<std::size_t> placesOf(Frames& frames)
{
	std::stable_sort(frames.begin(), frames.end(),
	                 [](const DicomFrame& a, const DicomFrame& b)
	                 { return std::pair(a.depth(), a.number) < std::pair(b.depth(), b.number); });
	std::vector<std::size_t> places(frames.size(), 0);
	for (std::size_t f = 1; f < frames.size(); ++f)
	{
		const bool is_same = frames[f].depth() - frames[f - 1].depth() < kSamePlace;
		places[f] = places[f - 1] + (is_same ? 0 : 1);
		const auto& a = frames[f - 1].origin;
		const auto& b = frames[f].origin;
		if (is_same && std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) > 0.1 * frames[f].spacing[0] + kSamePlace)
			throw Refusal("its pictures lie beside each other, as tiles, not behind each other");
	}
	return places;
}

// Which step each frame belongs to, and the keys that told them apart.
struct Grouping
{
	std::vector<std::size_t> group;   // the group of each frame
	std::vector<std::size_t> key_ids; // in the order in which they were used
	std::size_t count = 1;
};

// Whether every place has the same frames of each group.
bool isComplete(const std::vector<std::size_t>& places, const std::vector<std::size_t>& group, std::size_t count)
{
	std::map<std::pair<std::size_t, std::size_t>, std::size_t> frames;
	for (std::size_t f = 0; f < places.size(); ++f)
		++frames[{places[f], group[f]}];
	std::vector<std::size_t> of_group(count, 0);
	for (const auto& [where, number] : frames)
	{
		if (of_group[where.second] != 0 && of_group[where.second] != number)
			return false;
		of_group[where.second] = number;
	}
	return frames.size() == (places.back() + 1) * count;
}

using Value = std::pair<double, std::string>;

Value valueOf(const DicomFrame& frame, std::size_t key)
{
	return key < frame.keys.size() ? Value(frame.keys[key].number, frame.keys[key].text) : Value();
}

// Splits the groups by one more key, where that is a volume for each of its values.
void split(const Frames& frames, const std::vector<std::size_t>& places, std::size_t key, Grouping& grouping)
{
	std::map<std::pair<std::size_t, Value>, std::size_t> numbers;
	for (std::size_t f = 0; f < frames.size(); ++f)
		numbers[{grouping.group[f], valueOf(frames[f], key)}] = 0;
	if (numbers.size() == grouping.count)
		return;
	std::size_t count = 0;
	for (auto& [value, number] : numbers)
		number = count++;
	std::vector<std::size_t> group(frames.size());
	for (std::size_t f = 0; f < frames.size(); ++f)
		group[f] = numbers[{grouping.group[f], valueOf(frames[f], key)}];
	if (!isComplete(places, group, count))
		return;
	grouping = {std::move(group), std::move(grouping.key_ids), count};
	grouping.key_ids.push_back(key);
}

// Frames that no key tells apart are taken in the order of the numbers in each place.
bool splitByNumber(const std::vector<std::size_t>& places, Grouping& grouping)
{
	std::map<std::pair<std::size_t, std::size_t>, std::size_t> seen; // in each place, of each group
	std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;
	std::vector<std::size_t> rank(places.size());
	for (std::size_t f = 0; f < places.size(); ++f)
	{
		rank[f] = seen[{places[f], grouping.group[f]}]++;
		numbers[{grouping.group[f], rank[f]}] = 0;
	}
	const bool was_split = numbers.size() != grouping.count;
	std::size_t count = 0;
	for (auto& [value, number] : numbers)
		number = count++;
	for (std::size_t f = 0; f < places.size(); ++f)
		grouping.group[f] = numbers[{grouping.group[f], rank[f]}];
	grouping.count = count;
	return was_split;
}

void setTimes(const Frames& frames, const Grouping& grouping, bool by_number, DicomSteps& steps)
{
	steps.times.resize(grouping.count);
	std::iota(steps.times.begin(), steps.times.end(), 0.0);
	const DicomKey* key = grouping.key_ids.size() == 1 ? &frames[0].keys[grouping.key_ids[0]] : nullptr;
	steps.are_seconds = !by_number && key && key->seconds != 0.0;
	if (!steps.are_seconds)
		return;
	for (std::size_t f = 0; f < frames.size(); ++f)
		steps.times[grouping.group[f]] = frames[f].keys[grouping.key_ids[0]].number * key->seconds;
}

void noteKeys(const Grouping& grouping, DicomFrames& all)
{
	std::vector<std::string> names;
	bool is_time = true;
	for (const std::size_t id : grouping.key_ids)
	{
		names.push_back(all.frames[0].keys[id].name);
		is_time = is_time && all.frames[0].keys[id].is_time;
	}
	if (!is_time)
		all.note(fmt::format("{} volumes in one place differ in {}; --time #0 to #{} chooses one", grouping.count,
		                     fmt::join(names, " and "), grouping.count - 1));
}

} // namespace

DicomSteps stepsOf(DicomFrames& all)
{
	keepLargestStack(all);
	Frames& frames = all.frames;
	checkAxes(frames[0].axes);
	refuseMixed(frames);
	const bool is_placed = std::all_of(frames.begin(), frames.end(), [](const auto& frame) { return frame.has_place; });
	if (!is_placed && frames.size() > 1)
		throw Refusal("its files do not say where their slices lie (ImagePositionPatient)");
	const auto places = placesOf(frames);
	if (places.back() == 0)
		throw Refusal(
		    frames.size() > 1
		        ? fmt::format("nothing to slice: {} pictures of one place, as at several times", frames.size())
		        : "nothing to slice: a single picture; keep the files of a series in one folder");

	Grouping grouping{std::vector<std::size_t>(frames.size(), 0), {}, 1};
	bool by_number = false;
	if (places.back() + 1 < frames.size())
	{
		for (std::size_t key = 0; key < frames[0].keys.size(); ++key)
			split(frames, places, key, grouping);
		by_number = splitByNumber(places, grouping);
		if (!isComplete(places, grouping.group, grouping.count))
			throw Refusal(
			    frames.front().file == frames.back().file
			        ? "several of its frames lie in one place, and not equally many in each; dcm2niix may sort "
			          "them"
			        : "its slices lie in the same place, and not equally many in each; keep one time in a "
			          "folder");
	}
	DicomSteps steps;
	steps.steps.resize(grouping.count);
	for (std::size_t f = 0; f < frames.size(); ++f)
		steps.steps[grouping.group[f]].push_back(frames[f]);
	if (grouping.count > 1)
	{
		setTimes(frames, grouping, by_number, steps);
		noteKeys(grouping, all);
	}
	return steps;
}

} // namespace vp::reader::volumes
