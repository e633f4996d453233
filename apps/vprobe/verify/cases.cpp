#include "verify/cases.h"

#include "probe/json_reader.h"
#include "verify/sweep_frames.h"
#include "view/state_file.h"
#include "view/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace vp::app
{

namespace
{

constexpr std::string_view kStateEnding = ".json";
constexpr std::string_view kFiguresEnding = ".figures.json";

// A folder of states may hold other JSON files, as presets of colors or probes. States have a version.
bool mayBeState(const std::string& file)
{
	const Result<std::string> text = probe::readText(file, InputKind::state);
	const Result<nlohmann::json> document = text ? probe::parseJson(*text, file) : text.error();
	return !document || (document->is_object() && document->contains("version"));
}

Result<std::vector<std::string>> statesIn(const std::string& folder)
{
	std::error_code failed;
	std::vector<std::string> states;
	for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end;
	     entry.increment(failed))
	{
		const std::string file = entry->path().lexically_normal().string(); // without ./
		if (file.ends_with(kStateEnding) && !file.ends_with(kFiguresEnding) && mayBeState(file))
			states.push_back(file);
	}
	if (failed)
		return Error{ErrorKind::input, fmt::format("{}: cannot be listed: {}", folder, failed.message())};
	if (states.empty())
		return Error{ErrorKind::input, fmt::format("{}: holds no state; write one with vprobe render INPUT --save {}",
		                                           folder, (std::filesystem::path(folder) / "NAME.json").string())};
	std::ranges::sort(states);
	return states;
}

VerifyCase caseOf(const std::string& state, const view::MachineSpec& machine, bool may_be_alone)
{
	VerifyCase one;
	one.state = state;
	std::error_code unknown;
	one.has_picture = std::filesystem::exists(one.picture(), unknown);
	one.has_flat =
	    std::filesystem::exists(one.flat(), unknown) || std::filesystem::exists(one.beside(".flat.0.png"), unknown);
	one.has_figures = std::filesystem::exists(one.figures(), unknown);
	one.has_frames = std::ranges::any_of(SweepFrames::kEndings, [&](const char* ending)
	                                     { return std::filesystem::exists(one.beside(ending), unknown); });
	Status ready = view::loadState(one.spec, state);
	one.spec.machine = machine;
	if (ready && one.spec.input.files.empty())
		ready = Error{ErrorKind::input, fmt::format("{}: names no input; add \"input\": {{\"files\": [...]}}", state)};
	if (ready)
		ready = view::validate(one.spec);
	if (ready && !one.hasAny() && !may_be_alone)
		ready = Error{ErrorKind::input,
		              fmt::format("{}: nothing is expected of it; --update writes {}", state, one.picture())};
	if (!ready)
		one.wrong = ready.error();
	return one;
}

} // namespace

std::string VerifyCase::beside(const std::string& ending) const
{
	return (state.ends_with(kStateEnding) ? state.substr(0, state.size() - kStateEnding.size()) : state) + ending;
}

std::vector<VerifyCase> findCases(const std::vector<std::string>& places, const view::MachineSpec& machine,
                                  bool may_be_alone)
{
	std::vector<VerifyCase> cases;
	for (const std::string& place : places)
	{
		std::error_code unknown;
		if (!std::filesystem::is_directory(place, unknown))
		{
			cases.push_back(caseOf(place, machine, may_be_alone));
			continue;
		}
		const Result<std::vector<std::string>> states = statesIn(place);
		if (!states)
		{
			VerifyCase& folder = cases.emplace_back();
			folder.state = place;
			folder.wrong = states.error();
		}
		else
			for (const std::string& state : *states)
				cases.push_back(caseOf(state, machine, may_be_alone));
	}
	// Those of one input follow its first one.
	std::vector<VerifyCase> ordered;
	while (!cases.empty())
	{
		const view::InputSpec input = cases.front().spec.input;
		const auto rest = std::stable_partition(cases.begin() + 1, cases.end(),
		                                        [&](const VerifyCase& one) { return one.spec.input == input; });
		std::move(cases.begin(), rest, std::back_inserter(ordered));
		cases.erase(cases.begin(), rest);
	}
	return ordered;
}

} // namespace vp::app
