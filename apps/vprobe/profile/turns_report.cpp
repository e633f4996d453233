#include "profile/turns_report.h"

#include "report/duration.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vp::app
{

namespace
{

using nlohmann::json;

constexpr double kConfidence = 0.95;

// A, B, C ...
std::string letterOf(std::size_t contender)
{
	return contender < 26 ? std::string(1, static_cast<char>('A' + contender)) : fmt::format("S{}", contender + 1);
}

// The confidence of the frame is its own; those of the stages hold together.
std::vector<double> confidencesOf(const std::vector<RatioEstimate>& estimates)
{
	std::vector<double> chances;
	for (std::size_t stage = 1; stage < estimates.size(); ++stage)
		chances.push_back(estimates[stage].chance());
	std::vector<double> confidences = holmConfidences(chances);
	confidences.insert(confidences.begin(), kConfidence);
	return confidences;
}

json stagesOf(const Turns& turns, std::size_t contender)
{
	std::vector<RatioEstimate> estimates;
	std::vector<std::size_t> measured; // stages that both have
	for (std::size_t stage = 0; stage < turns.stages().size(); ++stage)
	{
		const PairedRatios& ratios = turns.ratios(contender, stage);
		if (ratios.rounds() < 2)
			continue;
		estimates.push_back(ratios.estimate());
		measured.push_back(stage);
	}
	const std::vector<double> confidences = confidencesOf(estimates);
	json list = json::array();
	for (const std::size_t stage : turns.order())
	{
		const Turns::Stage& told = turns.stages()[stage];
		json row{{"stage", told.title()},
		         {"depth", told.depth},
		         {"first_ms", turns.medianMs(0, stage)},
		         {"ms", turns.medianMs(contender, stage)}};
		const auto at = std::ranges::find(measured, stage);
		if (at == measured.end())
			row.update({{"ratio", nullptr}, {"low", nullptr}, {"high", nullptr}, {"confidence", nullptr}});
		else
		{
			const auto k = static_cast<std::size_t>(at - measured.begin());
			const Interval interval = estimates[k].interval(confidences[k]);
			row.update({{"ratio", estimates[k].ratio()},
			            {"low", interval.low},
			            {"high", interval.high},
			            {"confidence", confidences[k]}});
		}
		row["rounds"] = turns.ratios(contender, stage).rounds();
		list.push_back(std::move(row));
	}
	return list;
}

const char* verdictOf(const json& stage, double limit)
{
	if (stage["ratio"].is_null())
		return "not measured";
	if (stage["low"] > limit)
		return "above";
	return stage["high"] > limit ? "not decided" : "within";
}

json judged(const json& stages, const TimeLimit& limit)
{
	const auto stage = std::ranges::find_if(stages, [&](const json& row) { return row["stage"] == limit.stage; });
	return {{"stage", limit.stage}, {"at_most", limit.ratio}, {"verdict", verdictOf(*stage, limit.ratio)}};
}

std::string stageRow(const json& stage)
{
	const std::string name =
	    std::string(2 * stage["depth"].get<std::size_t>(), ' ') + stage["stage"].get<std::string>();
	const auto ms = [](double time) { return time > 0.0 ? fmt::format("{:.3f}", time) : std::string("-"); };
	std::string text = fmt::format("{:<22} {:>10} {:>10}", name, ms(stage["first_ms"]), ms(stage["ms"]));
	if (stage["ratio"].is_null())
		return text + fmt::format(" {:>9}\n", "-");
	const double low = stage["low"], high = stage["high"];
	return text + fmt::format(" {:>9.3f}   {:.3f} to {:.3f}{}\n", stage["ratio"].get<double>(), low, high,
	                          low > 1.0    ? "  slower"
	                          : high < 1.0 ? "  faster"
	                                       : "");
}

std::string settingsText(const json& settings)
{
	std::string text;
	for (const json& setting : settings)
	{
		const std::string what = setting["program"].is_string() ? setting["program"].get<std::string>()
		                         : setting["options"].is_null() ? std::string("as the other options say")
		                                                        : setting["options"].get<std::string>();
		text += fmt::format("{}: {}; first plane {}\n", setting["name"].get<std::string>(), what,
		                    durationText(setting["first_ms"].get<double>()));
	}
	return text;
}

std::string comparisonText(const json& versus)
{
	const std::string name = versus["name"];
	std::string text =
	    fmt::format("\n{:<22} {:>10} {:>10} {:>9}   {}\n", "ms a plane", "A", name, name + " / A", "95 % interval");
	for (const json& stage : versus["stages"])
		if (stage["first_ms"] > 0.0 || stage["ms"] > 0.0)
			text += stageRow(stage);
	for (const json& limit : versus["limits"])
		text += fmt::format("{} at most {:g}: {}\n", limit["stage"].get<std::string>(), limit["at_most"].get<double>(),
		                    limit["verdict"].get<std::string>());
	return text;
}

} // namespace

Result<TimeLimit> parseTimeLimit(const std::string& text)
{
	const std::size_t equals = text.rfind('=');
	TimeLimit limit;
	if (equals != text.npos)
		limit.stage = text.substr(0, equals);
	const std::string number = equals == text.npos ? text : text.substr(equals + 1);
	const char* end = number.data() + number.size();
	const auto [stop, failed] = std::from_chars(number.data(), end, limit.ratio);
	if (failed != std::errc() || stop != end || !(limit.ratio > 0.0) || !std::isfinite(limit.ratio) ||
	    limit.stage.empty())
		return Error{ErrorKind::usage, fmt::format("{}: give a ratio above 0, such as 1.05 or emit=1.05", text)};
	return limit;
}

Status checkLimits(const Turns& turns, const std::vector<TimeLimit>& limits)
{
	for (const TimeLimit& limit : limits)
	{
		std::vector<std::string> names;
		for (const Turns::Stage& stage : turns.stages())
			names.push_back(stage.title());
		if (std::ranges::find(names, limit.stage) == names.end())
			return Error{ErrorKind::usage, fmt::format("--at-most {}={:g}: no stage of this name was measured; use {}",
			                                           limit.stage, limit.ratio, fmt::join(names, ", "))};
	}
	return Nothing{};
}

json turnsJson(const Turns& turns, const std::vector<TimeLimit>& limits, const json& subject)
{
	json settings = json::array();
	json versus = json::array();
	for (std::size_t c = 0; c < turns.contenders().size(); ++c)
	{
		const Contender& contender = turns.contenders()[c];
		const bool is_setting = contender.kind() == Contender::Kind::setting;
		const bool is_build = contender.kind() == Contender::Kind::build;
		settings.push_back({{"name", letterOf(c)},
		                    {"options", is_setting ? json(contender.text()) : json()},
		                    {"program", is_build ? json(contender.text()) : json()},
		                    {"first_ms", turns.firstMs(c)}});
		if (c == 0)
			continue;
		json stages = stagesOf(turns, c);
		json verdicts = json::array();
		for (const TimeLimit& limit : limits)
			verdicts.push_back(judged(stages, limit));
		versus.push_back({{"name", letterOf(c)}, {"stages", std::move(stages)}, {"limits", std::move(verdicts)}});
	}
	json document = subject;
	document.update({{"plane_by_plane", turns.planeByPlane()},
	                 {"rounds", turns.rounds()},
	                 {"settings", std::move(settings)},
	                 {"versus", std::move(versus)}});
	return document;
}

std::string turnsTable(const json& document)
{
	std::string text =
	    fmt::format("{}: {} planes along {}, in turns, {} rounds\n", document["input"].get<std::string>(),
	                document["planes"].get<int>(), document["path"].get<std::string>(), document["rounds"].get<int>());
	if (!document["plane_by_plane"])
		text += "A build cannot measure plane by plane, so each program ran as a whole, twice in each round.\n";
	text += settingsText(document["settings"]);
	for (const json& versus : document["versus"])
		text += comparisonText(versus);
	return text;
}

bool exceedsLimit(const json& document)
{
	for (const json& versus : document["versus"])
		for (const json& limit : versus["limits"])
			if (limit["verdict"] == "above")
				return true;
	return false;
}

} // namespace vp::app
