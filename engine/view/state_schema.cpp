#include "view/state_schema.h"

#include "view/settings.h"
#include "view/state_file.h"
#include "view/words.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace vp::view
{

namespace
{

using nlohmann::ordered_json;

// The schema of a setting's value.
struct SchemaOf
{
	const std::optional<Limits>& limits;

	ordered_json number(const char* type) const
	{
		ordered_json schema{{"type", type}};
		if (!limits)
			return schema;
		if (limits->lo == std::numeric_limits<double>::min())
			schema["exclusiveMinimum"] = 0;
		else
			schema["minimum"] = limits->lo;
		if (limits->hi < std::numeric_limits<double>::max())
			schema["maximum"] = limits->hi;
		return schema;
	}
	static ordered_json words() { return {{"type", "string"}, {"minLength", 1}}; }
	static ordered_json listOf(ordered_json item, std::size_t least, std::size_t most)
	{
		return {{"type", "array"}, {"minItems", least}, {"maxItems", most}, {"items", std::move(item)}};
	}
	static ordered_json oneOf(const std::vector<std::string>& names, const char* own)
	{
		return {{"oneOf", {{{"enum", names}}, {{"$ref", own}}}}};
	}

	ordered_json operator()(const std::string*) const { return words(); }
	ordered_json operator()(const std::optional<std::string>*) const { return {{"type", "string"}}; }
	ordered_json operator()(const int*) const { return number("integer"); }
	ordered_json operator()(const std::optional<int>*) const { return number("integer"); }
	ordered_json operator()(const double*) const { return number("number"); }
	ordered_json operator()(const std::optional<double>*) const { return number("number"); }
	ordered_json operator()(const bool*) const { return {{"type", "boolean"}}; }
	ordered_json operator()(Bytes) const { return number("number"); }
	ordered_json operator()(const Text& text) const
	{
		return text.words.empty() ? words() : ordered_json{{"enum", text.words}};
	}
	ordered_json operator()(const Texts&) const { return listOf(words(), 1, kMaxListed); }
	ordered_json operator()(const Numbers& list) const
	{
		return listOf({{"type", "number"}}, list.count ? list.count : 1, list.count ? list.count : kMaxListed);
	}
	ordered_json operator()(Files) const { return {{"type", "array"}, {"minItems", 1}, {"items", words()}}; }
	ordered_json operator()(File) const { return words(); }
	ordered_json operator()(NameOrFile) const { return words(); }
	ordered_json operator()(ProbeChoice) const { return oneOf(view::wordsOf<ProbeShape>(), "probe.schema.json"); }
	ordered_json operator()(PathChoice) const { return oneOf(pathKindNames(), "path.schema.json"); }
};

ordered_json objectOf(ordered_json properties)
{
	return {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

} // namespace

std::string stateSchema()
{
	ordered_json sections{{"$schema", {{"type", "string"}}}, {"version", {{"const", kStateVersion}}}};
	ViewSpec any;
	for (const Section& section : sectionsOf(any))
	{
		ordered_json properties = ordered_json::object();
		for (const Setting& setting : section.settings)
		{
			ordered_json& property = properties[setting.key];
			property["description"] = setting.help;
			property.update(std::visit(SchemaOf{setting.limits}, setting.place));
		}
		sections[section.key] = objectOf(std::move(properties));
	}
	ordered_json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
	                    {"$id", "state.schema.json"},
	                    {"title", "State"},
	                    {"description",
	                     "The settings of a cut and its picture. A key is the name of an option, with _ for -. "
	                     "What is left out is as without the option. Names of files are relative to the "
	                     "folder of this file."},
	                    {"required", {"version"}}};
	schema.update(objectOf(std::move(sections)));
	return schema.dump(1, '\t') + '\n';
}

} // namespace vp::view
