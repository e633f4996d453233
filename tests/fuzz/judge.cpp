#include "judge.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace fuzz
{

namespace
{

using nlohmann::json;

constexpr int kInputError = 2;
constexpr int kCheckFound = 5;
constexpr std::string_view kStart = "vprobe: ";

std::string wrongLines(const std::string& err)
{
	if (!err.empty() && err.back() != '\n')
		return "standard error does not end with a line end";
	std::istringstream lines(err);
	for (std::string line; std::getline(lines, line);)
	{
		if (!line.starts_with(kStart))
			return "a line on standard error does not start with \"vprobe: \": " + line;
		const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7F; };
		if (std::any_of(line.begin(), line.end(), is_control))
			return "a control character on standard error: " + line;
	}
	return {};
}

std::string wrongError(const ProgramRun& run, const std::string& file, const std::filesystem::path& out)
{
	if (std::count(run.err.begin(), run.err.end(), '\n') != 1)
		return "an error that is not one line";
	if (!run.err.starts_with(std::string(kStart) + file + ": "))
		return "an error that does not start with the file's name";
	if (!run.out.empty())
		return "an error with something on standard output";
	if (!std::filesystem::is_empty(out))
		return "an error that leaves " + std::filesystem::directory_iterator(out)->path().filename().string();
	return {};
}

std::string wrongCounts(const json& sheet, const json& grid)
{
	for (const char* name : {"cut_cells", "polygons", "vertices", "components", "cells_touched", "boundary_faces"})
		if (!sheet[name].is_number_unsigned() && !(sheet[name].is_number_integer() && sheet[name] >= 0))
			return std::string(name) + " is no count";
	// linear_cells also counts the parts of curved cells.
	if (sheet["linear_cut_cells"] > grid["linear_cells"])
		return "more cut cells than cells";
	return {};
}

// JSON has no NaN and no infinity: they show as null.
std::string wrongStats(const json& stats)
{
	if (!stats.is_object() || !stats["sheets"].is_array() || stats["sheets"].empty())
		return "the stats are no JSON";
	const json& sheet = stats["sheets"][0];
	for (const char* name : {"area", "nan_area"})
		if (!sheet[name].is_number() || sheet[name] < 0.0)
			return std::string(name) + " is no area: " + sheet[name].dump();
	for (const json& number : sheet["origin"])
		if (!number.is_number())
			return "the origin is no point: " + sheet["origin"].dump();
	// Null where values are infinite, or all of them NaN.
	const auto number = [&](const char* name) { return sheet[name].get<double>(); };
	if (sheet["min"].is_number() && sheet["mean"].is_number() && sheet["max"].is_number())
	{
		const double slack = 1e-6 * (std::abs(number("min")) + std::abs(number("max")));
		if (number("mean") < number("min") - slack || number("mean") > number("max") + slack)
			return "the mean " + sheet["mean"].dump() + " is not between min and max";
	}
	return wrongCounts(sheet, stats["grid"]);
}

std::string wrongInfo(const json& info)
{
	if (!info.is_object() || !info["grid"].is_object() || !info["arrays"].is_array())
		return "the information is no JSON";
	if (info["grid"]["cells"] <= 0 || info["grid"]["points"] <= 0)
		return "a grid without cells";
	for (const json& number : info["bounds"].flatten())
		if (!number.is_number())
			return "bounds that are no numbers: " + info["bounds"].dump();
	return {};
}

std::string wrongResult(Command command, const ProgramRun& run, const std::filesystem::path& out)
{
	switch (command)
	{
	case Command::slice:
		if (!std::filesystem::exists(out / "cut.vtp") || std::filesystem::is_empty(out / "cut.vtp"))
			return "done, but no slice was written";
		return wrongStats(json::parse(contentsOf(out / "stats.json"), nullptr, false));
	case Command::info:
		return wrongInfo(json::parse(run.out, nullptr, false));
	default:
		return json::parse(run.out, nullptr, false).is_object() ? "" : "what check found is no JSON";
	}
}

} // namespace

std::string judge(Command command, const ProgramRun& run, const std::string& file, const std::filesystem::path& out,
                  std::uint64_t memory_limit)
{
	if (run.ran_out_of_time)
		return "still running after its time";
	if (run.exit_code < 0)
		return "crashed by signal " + std::to_string(run.signal);
	if (run.peak_bytes > memory_limit)
		return "took " + std::to_string(run.peak_bytes >> 20) + " MiB of memory";
	if (std::string wrong = wrongLines(run.err); !wrong.empty())
		return wrong;
	if (run.exit_code == kInputError)
		return wrongError(run, file, out);
	if (run.exit_code != 0 && !(command == Command::check && run.exit_code == kCheckFound))
		return "exit code " + std::to_string(run.exit_code);
	return wrongResult(command, run, out);
}

} // namespace fuzz
