#include "view/setting_places.h"

#include "grid/field_choice.h"
#include "read/formats.h"

#include <fmt/format.h>

namespace vp::view
{

Text format(std::string* name)
{
	return {[name] { return name->empty() ? std::nullopt : std::optional(*name); },
	        [name](const std::string& words) -> Status
	        {
		        if (!read::findFormat(words))
			        return Error{ErrorKind::usage, "no such format; use one of " + read::formatNames()};
		        *name = words;
		        return Nothing{};
	        }};
}

Text direction(std::optional<Vec3>* value)
{
	return {[value] { return *value ? std::optional(directionText(**value)) : std::nullopt; },
	        [value](const std::string& words) -> Status
	        {
		        Result<Vec3> parsed = parseDirection(words);
		        if (!parsed)
			        return parsed.error();
		        *value = *parsed;
		        return Nothing{};
	        }};
}

Text surface(SurfaceSpec* value)
{
	return {[value]
	        {
		        std::string words = surfaceText(*value);
		        return words.empty() ? std::nullopt : std::optional(std::move(words));
	        },
	        [value](const std::string& words) -> Status
	        {
		        Result<SurfaceSpec> parsed = parseSurface(words);
		        if (!parsed)
			        return parsed.error();
		        *value = std::move(*parsed);
		        return Nothing{};
	        }};
}

Text isoValue(SurfaceSpec* value)
{
	return {.get = [] { return std::nullopt; },
	        .set = [value](const std::string& words) { return surface(value).set("iso:" + words); }};
}

Numbers windowLevel(std::optional<std::pair<double, double>>* range)
{
	return {2, [] { return std::vector<double>(); },
	        [range](const std::vector<double>& n) {
		        *range = std::pair{n[1] - 0.5 * n[0], n[1] + 0.5 * n[0]};
	        }};
}

Text component(std::optional<int>* value)
{
	return {[value] { return *value ? std::optional(grid::componentText(**value)) : std::nullopt; },
	        [value](const std::string& words) -> Status
	        {
		        const std::optional<int> parsed = grid::parseComponent(words);
		        if (!parsed)
			        return Error{ErrorKind::usage,
			                     "not a component; use magnitude, x, y, z, xx, xy and so on, or a number from 0"};
		        *value = *parsed;
		        return Nothing{};
	        }};
}

Texts contexts(std::vector<ContextSpec>* value)
{
	return {[value]
	        {
		        std::vector<std::string> words;
		        for (const ContextSpec& context : *value)
			        words.push_back(contextText(context));
		        return words;
	        },
	        [value](const std::vector<std::string>& words) -> Status
	        {
		        value->clear();
		        for (const std::string& each : words)
		        {
			        Result<ContextSpec> parsed = parseContext(each);
			        if (!parsed)
				        return Error{parsed.error().kind, fmt::format("{}: {}", each, parsed.error().message)};
			        value->push_back(std::move(*parsed));
		        }
		        return Nothing{};
	        }};
}

Numbers vector(std::optional<Vec3>* value)
{
	return {3,
	        [value] {
		        return *value ? std::vector{(*value)->x, (*value)->y, (*value)->z} : std::vector<double>();
	        },
	        [value](const std::vector<double>& n) {
		        *value = {n[0], n[1], n[2]};
	        }};
}

Numbers list(std::vector<double>* value)
{
	return {0, [value] { return *value; }, [value](const std::vector<double>& n) { *value = n; }};
}

} // namespace vp::view
