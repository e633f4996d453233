#include "profile/history.h"

#include "base/input_files.h"
#include "version.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

namespace vp::app
{

namespace
{

using nlohmann::json;

// Keys of a profile that say what was measured. Runs are compared if all of them agree.
constexpr const char* kWorkKeys[] = {"input",   "grid",  "array",   "device",    "classifier",
                                     "finder",  "probe", "surface", "threshold", "seeds",
                                     "crinkle", "path",  "planes",  "picture",   "threads"};

// The model of the processor, and how many there are.
std::string machineName()
{
	std::ifstream info("/proc/cpuinfo");
	std::string model = "unknown processor";
	for (std::string line; std::getline(info, line);)
		if (line.starts_with("model name") && line.find(": ") != line.npos)
		{
			model = line.substr(line.find(": ") + 2);
			break;
		}
	return fmt::format("{}, {} threads", model, std::thread::hardware_concurrency());
}

std::optional<HistoryRun> parseRun(const json& line)
{
	if (!line.is_object() || !line.contains("work") || !line.contains("time") || !line["time"].is_string() ||
	    !line.contains("stages") || !line["stages"].is_array() || line["stages"].empty())
		return std::nullopt;
	HistoryRun run;
	run.time = line["time"];
	const json& label = line.value("label", json());
	run.label = label.is_string() ? label.get<std::string>() : run.time.substr(0, 10);
	for (const json& stage : line["stages"])
	{
		if (!stage.is_object() || !stage.value("stage", json()).is_string() ||
		    !stage.value("median", json()).is_number())
			return std::nullopt;
		run.stages.emplace_back(stage["stage"], stage["median"]);
	}
	return run;
}

std::string subjectOf(const json& line)
{
	const json& work = line["work"];
	const auto text = [&](const char* key)
	{
		const json value = work.value(key, json());
		return value.is_string() ? value.get<std::string>() : value.dump();
	};
	return fmt::format("{}, {} planes along {}, by the {}; {}; device {}", text("input"), text("planes"), text("path"),
	                   text("classifier"), line.value("machine", "unknown machine"), text("device"));
}

} // namespace

Status appendRun(const std::string& path, const std::string& label, const json& profile)
{
	json line{{"time", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
	          {"label", label.empty() ? json() : json(label)},
	          {"version", kVersion},
	          {"machine", machineName()},
	          {"stages", json::array()},
	          {"work", json::object()}};
	for (const char* key : kWorkKeys)
		line["work"][key] = profile.value(key, json());
	for (const char* list : {"stages", "gpu_stages"})
		for (const json& stage : profile[list])
			line["stages"].push_back(
			    {{"stage", (list == std::string("stages") ? "" : "gpu ") + stage["stage"].get<std::string>()},
			     {"median", stage["median"]}});
	const std::string text = line.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
	std::error_code unknown;
	if (const std::filesystem::path folder = std::filesystem::path(path).parent_path(); !folder.empty())
		std::filesystem::create_directories(folder, unknown); // as for all output; open() tells what is wrong
	// One call writes the whole line, so runs that end at the same time do not mix theirs.
	const int file = open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
	const ssize_t written = file < 0 ? -1 : ::write(file, text.data(), text.size());
	const int reason = errno;
	if (file >= 0)
		close(file);
	if (written == static_cast<ssize_t>(text.size()))
		return Nothing{};
	return Error{ErrorKind::output,
	             fmt::format("{}: cannot be written ({}); choose another place", path, strerror(reason))};
}

Result<History> readHistory(const std::string& path)
{
	noteInput(path);
	std::ifstream stream(path, std::ios::binary);
	std::error_code unknown;
	if (!stream || std::filesystem::is_directory(path, unknown))
		return Error{ErrorKind::input,
		             fmt::format("{}: cannot be read; give a file that vprobe profile --append wrote", path)};
	std::vector<std::pair<json, HistoryRun>> all;
	std::size_t number = 0;
	for (std::string text; std::getline(stream, text);)
	{
		++number;
		const auto is_shallow = [](int depth, json::parse_event_t, json&) { return depth <= 16; };
		const json line = json::parse(text, is_shallow, false);
		std::optional<HistoryRun> run = parseRun(line);
		if (!run)
			return Error{ErrorKind::input,
			             fmt::format("{}: line {} is no run; give a file that vprobe profile --append "
			                         "wrote, or remove the line",
			                         path, number)};
		all.emplace_back(line, std::move(*run));
	}
	if (all.empty())
		return Error{ErrorKind::input, fmt::format("{}: holds no run; add some by vprobe profile --append", path)};
	const json& last = all.back().first;
	History history{.subject = subjectOf(last)};
	for (auto& [line, run] : all)
		if (line["work"] == last["work"] && line.value("machine", "") == last.value("machine", ""))
			history.runs.push_back(std::move(run));
	history.others = all.size() - history.runs.size();
	return history;
}

} // namespace vp::app
