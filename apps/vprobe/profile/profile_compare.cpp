#include "profile/profile_compare.h"

#include "base/input_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

namespace vp::app
{

namespace
{

using nlohmann::json;

constexpr std::uintmax_t kMaxBytes = 64u << 20; // size of a profile: a generation takes some 200 bytes

// By how many times as long two runs of one program may take, although nothing has changed. The runs were at different
// times, and nothing in their files tells what else the machine did then (docs/PROFILE.md).
constexpr double kRunFactor = 2.0;
constexpr double kOnceFactor = 3.0; // for a figure that is measured once per run, and for the slowest planes
constexpr double kResidentFactor = 1.05;
constexpr double kWakeMs = 0.05; // a thread that the system wakes late adds this to any time

// A figure of a profile. If the ratio of two runs' figures is not above `factor`, or the difference not above `least`,
// that may be chance.
struct Figure
{
	double value;
	double factor;
	double least = 0.0;
};
using Figures = std::map<std::string, Figure>;

bool isSpread(const json& value)
{
	return value.is_object() && value.contains("median") && value.contains("noise");
}

void addSpread(const std::string& key, const json& spread, Figures& figures)
{
	const auto add = [&](const char* name, double factor)
	{
		if (const auto at = spread.find(name); at != spread.end() && at->is_number())
			figures[key + "." + name] = {at->get<double>(), factor, kWakeMs};
	};
	add("median", kRunFactor);
	add("p95", kOnceFactor);
	add("first", kOnceFactor);
}

// A count has no noise.
double factorOf(const std::string& key)
{
	if (key.starts_with("setup_ms."))
		return kOnceFactor;
	if (key == "ns_per_cut_cell" || key == "cells_per_second" || key == "break_even_cells")
		return kRunFactor;
	return key == "memory_bytes.peak_rss" ? kResidentFactor : 1.0;
}

void addFigures(const std::string& prefix, const json& object, Figures& figures)
{
	for (const auto& [name, value] : object.items())
	{
		const std::string key = prefix + name;
		if (isSpread(value))
			addSpread(key, value, figures);
		else if (value.is_object())
			addFigures(key + ".", value, figures);
		else if (value.is_number())
			figures[key] = {value.get<double>(), factorOf(key), key.starts_with("setup_ms.") ? kWakeMs : 0.0};
		else if (value.is_array() && name.ends_with("stages"))
			for (const json& stage : value)
				if (isSpread(stage) && stage.contains("stage") && stage["stage"].is_string())
					addSpread(key + "." + stage["stage"].get<std::string>(), stage, figures);
	}
}

// Keys that say what was measured, as profile_report.cpp writes them.
constexpr const char* kSubject[] = {"input", "grid",    "array",     "device", "classifier", "finder",
                                    "probe", "surface", "threshold", "seeds",  "crinkle",    "sheets",
                                    "path",  "planes",  "picture",   "threads"};

Figures figuresOf(json document)
{
	for (const char* key : kSubject)
		document.erase(key);
	document.erase("floor"); // the machine's
	Figures figures;
	addFigures("", document, figures);
	return figures;
}

struct Change
{
	std::string key;
	std::optional<Figure> a;
	std::optional<Figure> b;

	bool sameValue() const { return a && b && a->value == b->value; }
	bool byChance() const
	{
		if (sameValue())
			return true;
		if (!a || !b || a->factor == 1.0)
			return false;
		const auto [low, high] = std::minmax(a->value, b->value);
		return high <= a->factor * low || high - low <= a->least;
	}
	double ratio() const { return a && b ? b->value / a->value : std::numeric_limits<double>::quiet_NaN(); }
	// Returns how much the values differ, for sorting. A figure that one run lacks comes first.
	double size() const
	{
		if (!a || !b || a->value <= 0.0 || b->value <= 0.0)
			return std::numeric_limits<double>::infinity();
		return std::abs(std::log(ratio()));
	}
};

std::vector<Change> changesBetween(const Figures& a, const Figures& b)
{
	std::map<std::string, Change> by_key;
	for (const auto& [key, figure] : a)
		by_key[key].a = figure;
	for (const auto& [key, figure] : b)
		by_key[key].b = figure;
	std::vector<Change> changes;
	for (auto& [key, change] : by_key)
	{
		change.key = key;
		changes.push_back(std::move(change));
	}
	std::ranges::stable_sort(changes, [](const Change& x, const Change& y)
	                         { return x.byChance() != y.byChance() ? y.byChance() : x.size() > y.size(); });
	return changes;
}

std::string numberText(const std::optional<Figure>& figure)
{
	return figure ? fmt::format("{:.6g}", figure->value) : "-";
}

std::string shortened(const json& value)
{
	const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
	return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

std::string subjectChanges(const json& a, const json& b)
{
	std::string text;
	for (const char* key : kSubject)
	{
		const json of_a = a.value(key, json());
		const json of_b = b.value(key, json());
		if (of_a == of_b)
			continue;
		const bool told = shortened(of_a) != shortened(of_b);
		text += fmt::format("  {}: {}\n", key, told ? shortened(of_a) + " | " + shortened(of_b) : "differs");
	}
	return text.empty() ? "" : "The two are not of the same work:\n" + text + "\n";
}

} // namespace

Result<json> readProfile(const std::string& file)
{
	const auto unusable = [&](const char* why) {
		return Error{ErrorKind::input, fmt::format("{}: {}; give a file that vprobe profile --json wrote", file, why)};
	};
	std::error_code failed;
	if (const std::uintmax_t bytes = std::filesystem::file_size(file, failed); !failed && bytes > kMaxBytes)
		return unusable("is larger than any profile");
	noteInput(file);
	std::ifstream stream(file, std::ios::binary);
	if (!stream || std::filesystem::is_directory(file, failed))
		return unusable("cannot be read");
	// No profile nests as deep as this. The limit protects the functions that walk through the document by recursion.
	const auto is_shallow = [](int depth, json::parse_event_t, json&) { return depth <= 16; };
	json document = json::parse(stream, is_shallow, false);
	if (!document.is_object())
		return unusable("is no JSON object");
	if (const auto cut = document.find("cut_ms"); cut == document.end() || !isSpread(*cut))
		return unusable("is no profile, it lacks cut_ms");
	return document;
}

std::string compareProfiles(const json& a, const json& b, const std::string& file_a, const std::string& file_b)
{
	std::string text =
	    fmt::format("A: {}\nB: {}\n\n{}The two were not measured in turns: a time that differs by less than {:g} times "
	                "({:g} times, if it was measured once) may be chance. To know, measure with --versus.\n\n",
	                file_a, file_b, subjectChanges(a, b), kRunFactor, kOnceFactor);
	text += fmt::format("{:<34} {:>12} {:>12} {:>8}\n", "", "A", "B", "B / A");
	std::size_t same = 0;
	for (const Change& change : changesBetween(figuresOf(a), figuresOf(b)))
	{
		if (change.sameValue())
		{
			++same;
			continue;
		}
		const bool has_ratio = std::isfinite(change.ratio());
		text += fmt::format("{:<34} {:>12} {:>12} {:>8}{}\n", change.key, numberText(change.a), numberText(change.b),
		                    has_ratio ? fmt::format("{:.3f}", change.ratio()) : "-",
		                    change.byChance() ? "  may be chance" : "");
	}
	return text + fmt::format("\n{} figures are the same\n", same);
}

} // namespace vp::app
