#include "profile/contender.h"

#include "options/arguments.h"
#include "profile/swept_probe.h"
#include "report/console.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <iostream>

#include <sys/prctl.h>

namespace vp::app
{

namespace
{

using nlohmann::json;

constexpr const char* kOwnProgram = "/proc/self/exe"; // the same build even if its file has been replaced since
constexpr int kPipeVersion = 1;

// Options for the process that measures in turns, and not for those that it starts. Each takes one argument.
constexpr std::array<std::string_view, 7> kTurnsOptions{"--versus", "--versus-program", "--rounds", "--at-most",
                                                        "--json",   "--save",           "--trace"};

std::vector<std::string> sharedArguments(const std::vector<std::string>& given)
{
	std::vector<std::string> shared;
	for (auto word = given.begin(); word != given.end(); ++word)
	{
		if (std::ranges::find(kTurnsOptions, *word) != kTurnsOptions.end())
		{
			if (++word == given.end())
				break;
			continue;
		}
		if (std::ranges::find(kTurnsOptions, std::string_view(*word).substr(0, word->find('='))) == kTurnsOptions.end())
			shared.push_back(*word);
	}
	return shared;
}

std::optional<std::vector<StageTime>> parseStages(const json& list, Timeline::Track track, const char* ms)
{
	std::vector<StageTime> times;
	for (const json& stage : list)
		if (stage.is_object() && stage.contains("stage") && stage["stage"].is_string() && stage.contains(ms) &&
		    stage[ms].is_number())
			times.push_back({stage["stage"], track, stage.value("depth", 0u), stage[ms]});
		else
			return std::nullopt;
	return times;
}

// Returns nothing if the document is not what a profile, or a plane's answer, looks like.
std::optional<std::vector<StageTime>> parseTimes(const json& document, const char* ms)
{
	if (!document.is_object() || !document.contains("stages") || !document.contains("gpu_stages"))
		return std::nullopt;
	auto times = parseStages(document["stages"], Timeline::Track::cpu, ms);
	const auto on_device = parseStages(document["gpu_stages"], Timeline::Track::gpu, ms);
	if (!times || !on_device || times->empty())
		return std::nullopt;
	times->insert(times->end(), on_device->begin(), on_device->end());
	return times;
}

json answerOf(const std::vector<StageTime>& times)
{
	json answer{{"stages", json::array()}, {"gpu_stages", json::array()}};
	for (const StageTime& time : times)
		answer[time.track == Timeline::Track::cpu ? "stages" : "gpu_stages"].push_back(
		    {{"stage", time.name}, {"depth", time.depth}, {"ms", time.ms}});
	return answer;
}

ErrorKind kindOf(int status)
{
	for (const ErrorKind kind : {ErrorKind::usage, ErrorKind::input, ErrorKind::device})
		if (static_cast<int>(exitCodeOf(kind)) == status)
			return kind;
	return ErrorKind::output;
}

} // namespace

std::string Contender::option() const
{
	if (kind_ == Kind::first)
		return {};
	return kind_ == Kind::build ? "--versus-program " + text_ : fmt::format("--versus '{}'", text_);
}

std::string Contender::program() const
{
	return kind_ == Kind::build ? text_ : kOwnProgram;
}

std::vector<std::string> Contender::arguments() const
{
	std::vector<std::string> all = sharedArguments(commandLine());
	if (kind_ == Kind::setting)
		all.insert(all.end(), {"--with", text_});
	return all;
}

Error Contender::failure(ChildProgram::End end) const
{
	std::string line = end.lines.empty() ? "" : end.lines.back();
	if (line.starts_with("vprobe: "))
		line.erase(0, line.find(' ') + 1);
	if (line.empty() && end.status == 0)
		line = "answers with something that is no profile; name a vprobe";
	else if (line.empty())
		line = fmt::format("ended with status {} and said nothing; run it alone to see why", end.status);
	return {kindOf(end.status), kind_ == Kind::first ? line : fmt::format("{}: {}", option(), line)};
}

Status Contender::start()
{
	child_.reset();
	std::vector<std::string> words = arguments();
	words.push_back("--turns-pipe");
	Result<ChildProgram> child = ChildProgram::start(program(), words);
	if (!child)
		return Error{child.error().kind, fmt::format("--versus-program {}", child.error().message)};
	child_.emplace(std::move(*child));
	return Nothing{};
}

Status Contender::waitUntilReady()
{
	const json greeting = json::parse(child_->hearLine().value_or(""), nullptr, false);
	if (greeting.is_object() && greeting.value("turns_pipe", 0) == kPipeVersion)
	{
		planes_ = greeting.value("planes", std::size_t(0));
		remarks_ = child_->saidOnErrors();
		return Nothing{};
	}
	ChildProgram::End end = child_->end();
	child_.reset();
	const bool is_unknown =
	    std::ranges::any_of(end.lines, [](const std::string& line) { return line.find("--turns-pipe") != line.npos; });
	return is_unknown ? Status(Nothing{}) : failure(std::move(end));
}

Result<std::vector<StageTime>> Contender::measure(std::size_t plane)
{
	child_->say(fmt::format("{}\n", plane));
	const json answer = json::parse(child_->hearLine().value_or(""), nullptr, false);
	if (auto times = parseTimes(answer, "ms"))
		return std::move(*times);
	return failure(child_->end());
}

Result<Contender::Whole> Contender::runWhole() const
{
	std::vector<std::string> words = arguments();
	words.insert(words.end(), {"--json", "-"});
	const bool has_floor = std::ranges::find(words, "--no-floor") == words.end();
	if (has_floor && kind_ != Kind::build) // an older build does not know the option
		words.push_back("--no-floor");
	Result<ChildProgram> child = ChildProgram::start(program(), words);
	if (!child)
		return child.error();
	const json profile = json::parse(child->hearAll(), nullptr, false);
	ChildProgram::End end = child->end();
	auto medians = parseTimes(profile, "median");
	if (!medians || end.status != 0)
		return failure(std::move(end));
	const json& first = profile.value("frame_ms", json()).is_object() ? profile["frame_ms"] : profile["cut_ms"];
	return Whole{std::move(*medians), first.value("first", 0.0)};
}

Status answerPlanes(const ProfileOptions& options)
{
	prctl(PR_SET_PDEATHSIG, SIGTERM); // nobody else wants an answer
	Result<SweptProbe> swept = SweptProbe::open(options);
	if (!swept)
		return swept.error();
	swept->takeSections();
	const auto answer = [](const json& document)
	{
		print("{}\n", document.dump());
		return flushOutput();
	};
	Status told = answer({{"turns_pipe", kPipeVersion}, {"planes", swept->planes()}});
	for (std::string line; told && std::getline(std::cin, line);)
	{
		std::size_t plane = swept->planes();
		std::from_chars(line.data(), line.data() + line.size(), plane);
		if (plane >= swept->planes())
			return Error{ErrorKind::usage,
			             fmt::format("{}: give a plane from 0 to {} on each line", line, swept->planes() - 1)};
		if (Status measured = swept->measure(plane); !measured)
			return measured;
		told = answer(answerOf(stageTimes(swept->takeSections())));
	}
	return told;
}

} // namespace vp::app
