#include "view/settings.h"
#include "view/words.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace vp::view
{

namespace
{

Error notANumber()
{
	return {ErrorKind::usage, "not a number"};
}

template <class T>
std::optional<T> numberFrom(std::string_view text)
{
	T number{};
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
	if (error != std::errc() || end != text.data() + text.size())
		return std::nullopt;
	return number;
}

// Takes a text as a command line has it. The errors name neither setting nor text.
struct TakeText
{
	const std::string& text;

	std::vector<std::string> words() const
	{
		std::istringstream stream(text);
		return {std::istream_iterator<std::string>(stream), {}};
	}
	template <class T>
	Status number(T& value) const
	{
		const std::optional<T> read = numberFrom<T>(text);
		if (!read)
			return notANumber();
		value = *read;
		return Nothing{};
	}

	Status operator()(std::string* value) const { return *value = text, Nothing{}; }
	Status operator()(std::optional<std::string>* value) const { return *value = text, Nothing{}; }
	Status operator()(int* value) const { return number(*value); }
	Status operator()(std::optional<int>* value) const { return number(value->emplace()); }
	Status operator()(double* value) const { return number(*value); }
	Status operator()(std::optional<double>* value) const { return number(value->emplace()); }
	Status operator()(bool* value) const
	{
		if (text != "true" && text != "false")
			return Error{ErrorKind::usage, "takes true or false"};
		*value = text == "true";
		return Nothing{};
	}
	Status operator()(Bytes bytes) const { return number(*bytes.value); }
	Status operator()(const Text& value) const { return value.set(text); }
	Status operator()(const Texts& value) const { return value.set(words()); }
	Status operator()(const Numbers& value) const
	{
		std::vector<double> numbers;
		for (const std::string& word : words())
			if (const std::optional<double> read = numberFrom<double>(word))
				numbers.push_back(*read);
			else
				return notANumber();
		if (numbers.empty() || (value.count > 0 && numbers.size() != value.count))
			return Error{ErrorKind::usage, fmt::format("takes {} numbers", value.count)};
		value.set(numbers);
		return Nothing{};
	}
	Status operator()(Files value) const { return *value.names = words(), Nothing{}; }
	Status operator()(File value) const { return *value.name = text, Nothing{}; }
	Status operator()(NameOrFile value) const { return *value.name = text, Nothing{}; }
	Status operator()(ProbeChoice choice) const
	{
		const Result<ProbeShape> shape = parse<ProbeShape>(text);
		if (!shape)
			return shape.error();
		choice.probe->shape = *shape;
		choice.probe->own.reset();
		return Nothing{};
	}
	Status operator()(PathChoice choice) const { return setPathKind(*choice.sweep, text); }
};

} // namespace

Status setByKey(ViewSpec& spec, std::string_view key, const std::string& text)
{
	std::string keys;
	const std::vector<Section> sections = allSectionsOf(spec);
	for (const Section& section : sections)
		for (const Setting& setting : section.settings)
		{
			keys += fmt::format("{}{}", keys.empty() ? "" : ", ", setting.key);
			if (key != setting.key)
				continue;
			const Status set = std::visit(TakeText{text}, setting.place);
			return set ? set : Error{set.error().kind, fmt::format("`{}` {}: {}", key, text, set.error().message)};
		}
	return Error{ErrorKind::usage, fmt::format("there is no setting '{}'; there are {}", key, keys)};
}

} // namespace vp::view
