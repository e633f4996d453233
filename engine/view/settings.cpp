#include "view/settings.h"

#include "probe/path_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace vp::view
{

namespace
{

struct NumbersOf
{
	std::vector<double> operator()(int* number) const { return {static_cast<double>(*number)}; }
	std::vector<double> operator()(double* number) const { return {*number}; }
	std::vector<double> operator()(std::optional<int>* number) const
	{
		return *number ? (*this)(&**number) : std::vector<double>();
	}
	std::vector<double> operator()(std::optional<double>* number) const
	{
		return *number ? (*this)(&**number) : std::vector<double>();
	}
	std::vector<double> operator()(Bytes bytes) const { return {*bytes.value}; }
	std::vector<double> operator()(const Numbers& numbers) const { return numbers.get(); }
	template <class T>
	std::vector<double> operator()(const T&) const
	{
		return {};
	}
};

std::string limitsText(const Limits& limits)
{
	if (limits.hi < std::numeric_limits<double>::max())
		return fmt::format("from {:g} to {}", limits.lo, limits.hi);
	return limits.lo > 0.0 ? "above 0" : fmt::format("of {:g} or more", limits.lo);
}

} // namespace

std::vector<Section> allSectionsOf(ViewSpec& spec)
{
	std::vector<Section> sections = sectionsOf(spec);
	sections.push_back(machineSection(spec));
	return sections;
}

Section sectionOf(ViewSpec& spec, std::string_view key)
{
	std::vector<Section> sections = allSectionsOf(spec);
	for (Section& section : sections)
		if (section.key == key)
			return std::move(section);
	throw std::out_of_range("no section of settings: " + std::string(key));
}

Setting settingOf(ViewSpec& spec, std::string_view key)
{
	std::vector<Section> sections = allSectionsOf(spec);
	for (Section& section : sections)
		for (Setting& setting : section.settings)
			if (setting.key == key)
				return std::move(setting);
	throw std::out_of_range("no setting: " + std::string(key));
}

std::string refusal(const Setting& setting)
{
	for (const double number : std::visit(NumbersOf(), setting.place))
	{
		if (setting.limits && !(number >= setting.limits->lo && number <= setting.limits->hi))
			return fmt::format("{}: give a number {}{}", number, limitsText(*setting.limits),
			                   number < setting.limits->lo ? setting.limits->instead : "");
		if (!std::isfinite(number))
			return fmt::format("{} is not a finite number", number);
	}
	return {};
}

std::vector<std::string> pathKindNames()
{
	return {"translate", "rotate", "spin", "revolve", "profile", "times"};
}

Status setPathKind(SweepSpec& sweep, std::string_view name)
{
	const std::optional<probe::PathKind> kind = probe::pathKind(name);
	if (name != "times" && (!kind || *kind == probe::PathKind::keyframes))
		return Error{ErrorKind::usage, name == "keyframes"
		                                   ? "keys come from a file; give its name, FILE.json (docs/PROBES.md)"
		                                   : fmt::format("takes {} or a .json file", fmt::join(pathKindNames(), ", "))};
	sweep.own.reset();
	sweep.over_times = name == "times";
	sweep.kind = kind.value_or(probe::PathKind::translate);
	return Nothing{};
}

std::string pathKindText(const SweepSpec& sweep)
{
	return sweep.over_times ? "times" : std::string(probe::nameOf(sweep.own ? sweep.own->kind : sweep.kind));
}

} // namespace vp::view
