#pragma once

#include "view/settings.h"
#include "view/words.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vp::view
{

// Make the places of settings whose values are written as text or as several numbers. They point to the values.

/// One of the words of an enumeration.
template <Named T>
Text word(T* value)
{
	return {.get = [value] { return std::optional<std::string>(text(*value)); },
	        .set = [value](const std::string& words) -> Status
	        {
		        Result<T> parsed = parse<T>(words);
		        if (!parsed)
			        return parsed.error();
		        *value = *parsed;
		        return Nothing{};
	        },
	        .words = wordsOf<T>()};
}

template <Named T>
Text word(std::optional<T>* value)
{
	return {.get = [value] { return *value ? std::optional<std::string>(text(**value)) : std::nullopt; },
	        .set = [value](const std::string& words) -> Status { return word(&value->emplace()).set(words); },
	        .words = wordsOf<T>()};
}

/// A value that `parse` reads and `write` writes.
template <class T, class Parse, class Write>
Text written(T* value, Parse parse, Write write)
{
	return {.get = [=]() -> std::optional<std::string> { return write(*value); },
	        .set = [=](const std::string& words) -> Status
	        {
		        auto parsed = parse(words);
		        if (!parsed)
			        return parsed.error();
		        *value = std::move(*parsed);
		        return Nothing{};
	        }};
}

/// A value about raw volumes. It is set only if the size of a raw volume is.
template <class T, class Parse, class Write>
Text ofRaw(const InputSpec& input, T* value, Parse parse, Write write)
{
	Text text = written(value, parse, write);
	text.if_not_set = write(*value);
	text.get = [&raw = input.raw, get = text.get] { return raw.size[0] == 0 ? std::nullopt : get(); };
	return text;
}

template <class T>
Numbers pair(std::optional<T>* value)
{
	return {2,
	        [value]
	        {
		        if (!*value)
			        return std::vector<double>();
		        const auto& [a, b] = **value;
		        return std::vector{a, b};
	        },
	        [value](const std::vector<double>& n) {
		        *value = T{n[0], n[1]};
	        }};
}

Text format(std::string* name);
Text direction(std::optional<Vec3>* value);
Text surface(SurfaceSpec* value);
/// The value of an iso surface, which is one kind of surface. Files have it in the setting of the surface.
Text isoValue(SurfaceSpec* value);
/// The range of the colors by its width and its middle. Files have it in the setting of the range.
Numbers windowLevel(std::optional<std::pair<double, double>>* range);
Text component(std::optional<int>* value);
Texts contexts(std::vector<ContextSpec>* value);
Numbers vector(std::optional<Vec3>* value);
Numbers list(std::vector<double>* value);

} // namespace vp::view
