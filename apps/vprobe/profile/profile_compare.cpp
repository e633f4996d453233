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

// Two runs of one program differ by this part of the value on an otherwise idle machine (docs/PROFILE.md).
constexpr double kRunNoise = 0.05;
constexpr double kOnceNoise = 0.25; // for a figure that is measured once per run
constexpr double kResidentNoise = 0.02;

// A figure of a profile, and by how much it may be off by chance.
struct Figure
{
	double value;
	double noise;
};
using Figures = std::map<std::string, Figure>;

double numberIn(const json& object, const char* key, double otherwise = 0.0)
{
	const auto at = object.find(key);
	return at != object.end() && at->is_number() ? at->get<double>() : otherwise;
}

bool isSpread(const json& value)
{
	return value.is_object() && value.contains("median") && value.contains("noise");
}

// Adds both figures with twice their standard errors. If a single measurement has the deviation `noise`, the standard
// error of the median of n is about 1.25 noise / sqrt(n), and that of their 95th percentile is 2.1 noise / sqrt(n).
void addSpread(const std::string& key, const json& spread, double planes, Figures& figures)
{
	const double noise = numberIn(spread, "noise");
	const double root = std::sqrt(std::max(1.0, planes));
	const auto add = [&](const char* name, double chance, double run_noise)
	{
		if (const auto at = spread.find(name); at != spread.end() && at->is_number())
			figures[key + "." + name] = {at->get<double>(), std::hypot(2.0 * chance, run_noise * at->get<double>())};
	};
	add("median", 1.25 * noise / root, kRunNoise);
	add("p95", 2.1 * noise / root, 2.0 * kRunNoise);
	add("first", noise, kOnceNoise);
}

double recordedNoise(const std::string& key, double value)
{
	if (key.starts_with("setup_ms."))
		return kOnceNoise * value;
	if (key == "ns_per_cut_cell" || key == "cells_per_second")
		return kRunNoise * value;
	return key == "memory_bytes.peak_rss" ? kResidentNoise * value : 0.0;
}

void addFigures(const std::string& prefix, const json& object, double planes, Figures& figures)
{
	for (const auto& [name, value] : object.items())
	{
		const std::string key = prefix + name;
		if (isSpread(value))
			addSpread(key, value, planes, figures);
		else if (value.is_object())
			addFigures(key + ".", value, planes, figures);
		else if (value.is_number())
			figures[key] = {value.get<double>(), recordedNoise(key, value.get<double>())};
		else if (value.is_array() && name.ends_with("stages"))
			for (const json& stage : value)
				if (isSpread(stage) && stage.contains("stage") && stage["stage"].is_string())
					addSpread(key + "." + stage["stage"].get<std::string>(), stage, planes, figures);
	}
}

// Keys that say what was measured, as profile_report.cpp writes them.
constexpr const char* kSubject[] = {"input", "grid",    "array",     "device", "classifier", "finder",
                                    "probe", "surface", "threshold", "seeds",  "crinkle",    "sheets",
                                    "path",  "planes",  "picture",   "threads"};

Figures figuresOf(json document)
{
	const double planes = numberIn(document, "planes", 1.0);
	for (const char* key : kSubject)
		document.erase(key);
	Figures figures;
	addFigures("", document, planes, figures);
	return figures;
}

struct Change
{
	std::string key;
	std::optional<Figure> a;
	std::optional<Figure> b;

	bool sameValue() const { return a && b && a->value == b->value; }
	bool byChance() const { return a && b && std::abs(a->value - b->value) <= std::hypot(a->noise, b->noise); }
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
	std::string text = fmt::format("A: {}\nB: {}\n\n{}", file_a, file_b, subjectChanges(a, b));
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
		                    change.byChance() ? "  by chance" : "");
	}
	return text + fmt::format("\n{} figures are the same\n", same);
}

} // namespace vp::app
