#include "read/manifest_values.h"

#include "base/control_letters.h"
#include "base/ids.h"
#include "grid/array_facts.h"
#include "read/check_mesh.h"
#include "read/protocol.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string_view>

namespace vp::read
{

namespace
{

using grid::NumberType;
using nlohmann::json;

constexpr std::size_t kMaxWords = 300;

} // namespace

std::uint64_t countOf(const json& value)
{
	if (!value.is_number_unsigned())
		throw Unusable("a count is not a whole number");
	return value.get<std::uint64_t>();
}

double finiteOf(const json& value)
{
	if (!value.is_number() || !std::isfinite(value.get<double>()))
		throw Unusable("an origin, a spacing or a time is not a finite number");
	return value.get<double>();
}

Vec3 vectorOf(const json& value)
{
	if (!value.is_array() || value.size() != 3)
		throw Unusable("a vector does not have three numbers");
	return {finiteOf(value[0]), finiteOf(value[1]), finiteOf(value[2])};
}

std::string wordsOf(const json& value)
{
	const std::string given = value.get<std::string>().substr(0, kMaxWords);
	std::string words;
	for (std::string_view rest = given; !rest.empty();)
	{
		const std::size_t control = controlLetter(rest);
		words += control == 0 ? rest[0] : ' ';
		rest.remove_prefix(control == 0 ? 1 : control);
	}
	return words;
}

ReadWarning warningOf(const json& value)
{
	if (value.is_object())
		return {countOf(value.at("count")), wordsOf(value.at("words"))};
	return {.words = wordsOf(value)};
}

NumberType numberTypeOf(const std::string& name)
{
	if (const std::optional<NumberType> type = grid::parseNumberType(name))
		return *type;
	throw Unusable("an array has an unknown number type");
}

grid::Association associationOf(const json& value)
{
	const auto& name = value.get_ref<const std::string&>();
	for (const grid::Association association : {grid::Association::point, grid::Association::cell})
		if (name == grid::associationName(association))
			return association;
	throw Unusable("an array belongs to neither points nor cells");
}

int componentsOf(const json& value, const std::string& name)
{
	const std::uint64_t components = countOf(value);
	if (components < 1 || components > kMaxComponents)
		throw Unusable(fmt::format("the array {} has {} components", name, components));
	return static_cast<int>(components);
}

// A manifest has some eight levels. Millions of brackets would take many times their own memory.
json parsedManifest(std::string_view text)
{
	constexpr int kMaxDepth = 32;
	const auto limited = [](int depth, json::parse_event_t, json&)
	{
		if (depth > kMaxDepth)
			throw Unusable("the manifest of its arrays is nested too deeply");
		return true;
	};
	return json::parse(text, limited);
}

std::string leftOutName(const json& array)
{
	return fmt::format("{}:{}", grid::associationName(associationOf(array.at("association"))),
	                   wordsOf(array.at("name")));
}

std::shared_ptr<const grid::ArrayFacts> factsOf(const json& facts, int components)
{
	auto found = std::make_shared<grid::ArrayFacts>();
	found->tuples = countOf(facts.at("tuples"));
	for (const json& each : facts.at("spans"))
	{
		grid::ValueSpan& span = found->spans.emplace_back();
		span.minus_infinity = each.at(2).get<bool>();
		span.plus_infinity = each.at(3).get<bool>();
		if (each.at(0).is_null())
			continue;
		span.lo = finiteOf(each.at(0));
		span.hi = finiteOf(each.at(1));
		if (span.empty())
			throw Unusable("the range of an array has its ends exchanged");
	}
	if (found->spans.size() != static_cast<std::size_t>(components) + 1)
		throw Unusable("an array has not a range for each of its components");
	if (const auto least = facts.find("least_positive"); least != facts.end())
	{
		for (const json& each : *least)
			found->least_positive.push_back(finiteOf(each));
		if (least->size() != found->spans.size() || std::ranges::min(found->least_positive) < 0.0)
			throw Unusable("an array has not the least value above 0 of each of its components");
	}
	for (const json& value : facts.at("values"))
		found->values.include(finiteOf(value));
	found->changes = {countOf(facts.at("changes").at(0)), countOf(facts.at("changes").at(1))};
	return found;
}

Array<std::byte> bytesOf(const SharedBytes& memory, const json& array, NumberType type, std::uint64_t numbers)
{
	const std::uint64_t offset = countOf(array.at("offset"));
	const std::uint64_t bytes = countOf(array.at("bytes"));
	if (offset % kArrayAlignment != 0 || offset > memory.bytes.size() || bytes > memory.bytes.size() - offset)
		throw Unusable("an array lies outside what was handed over");
	if (bytes % byteSize(type) != 0 || (numbers != kAnyCount && bytes / byteSize(type) != numbers))
		throw Unusable("an array has another size than it should");
	return {memory.owner, memory.bytes.data() + offset, static_cast<std::size_t>(bytes)};
}

Array<std::byte> bytesOfType(const SharedBytes& memory, const json& array, NumberType type, std::uint64_t numbers)
{
	if (numberTypeOf(array.at("type").get<std::string>()) != type)
		throw Unusable("an array has another number type than it should");
	return bytesOf(memory, array, type, numbers);
}

grid::Points coordinatesOf(const SharedBytes& memory, const json& array, std::uint64_t points)
{
	const std::uint64_t numbers = points == kAnyCount ? kAnyCount : points * 3;
	// nlohmann compares with a literal in a function that may not throw, but asks for memory.
	const bool is_double = array.at("type").get_ref<const std::string&>() == "float64";
	grid::Points checked = is_double ? grid::Points(numbersOf<double>(memory, array, NumberType::float64, numbers))
	                                 : grid::Points(numbersOf<float>(memory, array, NumberType::float32, numbers));
	if (countOf(array.at("bytes")) != checked.size() * 3 * (is_double ? 8 : 4))
		throw Unusable("points without three coordinates");
	if (checked.size() >= kMaxBlockIds)
		throw Unusable(fmt::format("a block of {} points is too large; split it", checked.size()));
	return checked;
}

grid::Imaging imagingOf(const json& manifest)
{
	const json imaging = manifest.value("imaging", json::object());
	grid::Imaging result{wordsOf(imaging.value("orientation", json(""))), imaging.value("gray", false),
	                     imaging.value("labels", false)};
	for (const json& label : imaging.value("label_names", json::array()))
	{
		const std::pair<double, std::string> named{finiteOf(label.at(0)), wordsOf(label.at(1))};
		if (!result.label_names.empty() && !(result.label_names.back().first < named.first))
			throw Unusable("names of labels are not in order");
		result.label_names.push_back(named);
	}
	if (const auto window = imaging.find("window"); window != imaging.end())
	{
		if (!window->is_array() || window->size() != 2)
			throw Unusable("a window of values does not have two ends");
		const double lo = finiteOf((*window)[0]), hi = finiteOf((*window)[1]);
		if (!(lo < hi))
			throw Unusable("a window of values is empty");
		result.window = {lo, hi};
	}
	return result;
}

} // namespace vp::read
