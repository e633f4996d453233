#include "verify/figures.h"

#include "probe/json_reader.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::app
{

namespace
{

using nlohmann::json;
using probe::JsonReader;

constexpr const char* kToleranceKey = "tolerance";

double positive(const JsonReader& from)
{
	const double number = from.number();
	if (!(number >= 0.0))
		from.refuse("a tolerance is 0 or more");
	return number;
}

void readTolerance(const JsonReader& from, FigureTolerance& tolerance)
{
	if (const auto relative = from.find("relative"))
		tolerance.relative = positive(*relative);
	if (const auto absolute = from.find("absolute"))
		tolerance.absolute = positive(*absolute);
}

Tolerances readTolerances(const JsonReader& from)
{
	from.expectKeys({"relative", "absolute", "keys", "picture"});
	Tolerances tolerances;
	readTolerance(from, tolerances.all);
	if (const auto keys = from.find("keys"))
	{
		if (!keys->isObject())
			keys->refuse("an object of tolerances by the keys of figures is expected");
		for (const auto& [key, value] : keys->value().items())
		{
			const JsonReader one = (*keys)[key.c_str()];
			one.expectKeys({"relative", "absolute"});
			readTolerance(one, tolerances.keys[key] = tolerances.all);
		}
	}
	if (const auto picture = from.find("picture"))
	{
		picture->expectKeys({"similarity", "mean"});
		tolerances.picture.emplace();
		if (const auto similarity = picture->find("similarity"))
			tolerances.picture->similarity = positive(*similarity);
		if (const auto mean = picture->find("mean"))
			tolerances.picture->mean = positive(*mean);
	}
	return tolerances;
}

// Goes through both documents together.
class FigureWalk
{
public:
	explicit FigureWalk(const Tolerances& tolerances) : tolerances_(tolerances) {}

	void compare(const json& expected, const json& figure, const std::string& place, const std::string& key)
	{
		if (expected.is_object() && figure.is_object())
			compareObjects(expected, figure, place);
		else if (expected.is_array() && figure.is_array() && expected.size() == figure.size())
			for (std::size_t i = 0; i < expected.size(); ++i)
				compare(expected[i], figure[i], fmt::format("{}/{}", place, i), key);
		else if (expected.is_array() && figure.is_array())
			moved_.push_back(
			    {place, fmt::format("a list of {}", expected.size()), fmt::format("a list of {}", figure.size()), ""});
		else if (expected.is_number() && figure.is_number())
			compareNumbers(expected, figure, place, key);
		else if (expected != figure)
			moved_.push_back({place, shown(expected), shown(figure), ""});
	}

	std::vector<MovedFigure> take() { return std::move(moved_); }

private:
	static std::string shown(const json& value)
	{
		constexpr std::size_t kLongest = 80;
		std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
		return text.size() > kLongest ? text.substr(0, kLongest) + "..." : text;
	}

	void compareObjects(const json& expected, const json& figure, const std::string& place)
	{
		for (const auto& [key, value] : expected.items())
		{
			if (place.empty() && key == kToleranceKey)
				continue;
			const std::string at = place.empty() ? key : place + "/" + key;
			if (const auto found = figure.find(key); found != figure.end())
				compare(value, *found, at, key);
			else
				moved_.push_back({at, shown(value), "none", ""});
		}
	}

	void compareNumbers(const json& expected, const json& figure, const std::string& place, const std::string& key)
	{
		const auto own = tolerances_.keys.find(key);
		const bool is_count = expected.is_number_integer() && figure.is_number_integer();
		const FigureTolerance tolerance = own != tolerances_.keys.end() ? own->second
		                                  : is_count                    ? FigureTolerance{0.0, 0.0}
		                                                                : tolerances_.all;
		const double wanted = expected.get<double>();
		const double may = std::max(tolerance.absolute, tolerance.relative * std::abs(wanted));
		if (std::abs(figure.get<double>() - wanted) <= may)
			return;
		moved_.push_back({place, shown(expected), shown(figure), may > 0.0 ? fmt::format("within {:.3g}", may) : ""});
	}

	const Tolerances& tolerances_;
	std::vector<MovedFigure> moved_;
};

// Figures that are the same on every machine, whatever way of searching the plan chose.
constexpr std::array kLastingFigures{
    "array", "cut_cells",     "polygons",      "vertices",      "components", "area", "mean",          "min",
    "max",   "boundary_area", "boundary_mean", "boundary_flux", "nan_area",   "flux", "cells_twisted", "labels"};

json lasting(const json& sheet)
{
	json kept = json::object();
	for (const char* key : kLastingFigures)
		if (const auto found = sheet.find(key); found != sheet.end() && !found->is_null())
			kept[key] = *found;
	return kept;
}

// Takes the figures of the keys that a document has. A list gets the length of today's.
json takenFrom(const json& figures, const json& document)
{
	if (document.is_object() && figures.is_object())
	{
		json taken = json::object();
		for (const auto& [key, value] : document.items())
			if (const auto found = figures.find(key); found != figures.end())
				taken[key] = takenFrom(*found, value);
		return taken;
	}
	if (!document.is_array() || !figures.is_array() || document.empty())
		return figures;
	json taken = json::array();
	for (std::size_t i = 0; i < figures.size(); ++i)
		taken.push_back(takenFrom(figures[i], document[std::min(i, document.size() - 1)]));
	return taken;
}

} // namespace

Result<Tolerances> tolerancesOf(const nlohmann::json& document, const std::string& file)
{
	const auto found = document.find(kToleranceKey);
	if (found == document.end())
		return Tolerances{};
	return probe::readDocument<Tolerances>(*found, file, fmt::format("/{}", kToleranceKey), readTolerances);
}

std::vector<MovedFigure> movedFigures(const nlohmann::json& expected, const nlohmann::json& figures,
                                      const Tolerances& tolerances)
{
	// A whole document of --stats tells of its run as well, which no other run repeats.
	constexpr std::array kOfTheRun{"ms", "version", "device", "driver", "sandbox"};
	nlohmann::json kept = expected;
	for (const char* key : kOfTheRun)
		kept.erase(key);
	FigureWalk walk(tolerances);
	walk.compare(kept, figures, "", "");
	return walk.take();
}

std::string text(const std::vector<MovedFigure>& moved)
{
	const MovedFigure& first = moved.front();
	std::string line = fmt::format("{} is {}, expected {}{}{}", first.place, first.drawn, first.expected,
	                               first.why.empty() ? "" : " ", first.why);
	if (moved.size() > 1)
		line += fmt::format(", and {} more", moved.size() - 1);
	return line;
}

Result<nlohmann::json> readFigures(const std::string& file)
{
	const Result<std::string> text = probe::readText(file, InputKind::state);
	if (!text)
		return text.error();
	Result<json> document = probe::parseJson(*text, file);
	if (document && !document->is_object())
		return Error{ErrorKind::input,
		             fmt::format("{}: holds no figures; write an object with some of the keys of --stats", file)};
	return document;
}

Result<std::vector<MovedFigure>> compareFigures(const std::string& file, const std::string& stats)
{
	const Result<json> expected = readFigures(file);
	if (!expected)
		return expected.error();
	const Result<Tolerances> tolerances = tolerancesOf(*expected, file);
	if (!tolerances)
		return tolerances.error();
	return movedFigures(*expected, json::parse(stats), *tolerances);
}

std::string newFigures(const nlohmann::json& figures)
{
	json kept = json::object();
	for (const json& sheet : figures["sheets"])
		kept["sheets"].push_back(lasting(sheet));
	for (const json& contour : figures["contours"])
		kept["contours"].push_back(
		    {{"value", contour["value"]}, {"polygons", contour["polygons"]}, {"area", contour["area"]}});
	return probe::jsonText(kept);
}

std::string updatedFigures(nlohmann::json expected, const nlohmann::json& figures)
{
	json kept = takenFrom(figures, expected);
	if (const auto tolerance = expected.find(kToleranceKey); tolerance != expected.end())
		kept[kToleranceKey] = *tolerance;
	return probe::jsonText(kept);
}

} // namespace vp::app
