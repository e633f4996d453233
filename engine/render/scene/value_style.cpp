#include "render/scene/value_style.h"

#include "render/scene/levels.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::render
{

namespace
{

ValueStyle styleOf(const ColorMap& colors, const ValueScale& values, const Look& look,
                   const std::optional<std::pair<double, double>>& range, int lines)
{
	ValueStyle style;
	style.colors = &colors;
	style.logarithmic = look.logarithmic && colors.categories.empty();
	style.per_cell = values.per_cell;
	style.lo = range ? range->first : style.logarithmic ? values.log_lo : values.lo;
	style.hi = range ? range->second : values.hi;
	// A sheet's own range may reach where there is no logarithm.
	if (style.logarithmic && style.lo <= 0.0)
		style.lo = values.log_lo;
	if (style.logarithmic && !(style.lo > 0.0 && style.hi >= style.lo))
		style.lo = style.hi = 1.0; // nothing can be shown
	style.above = values.above || (values.reach ? values.reach->second > style.hi : range.has_value());
	style.below = values.below || (values.reach ? values.reach->first < style.lo : range.has_value()) ||
	              (style.logarithmic && values.lo <= 0.0);
	style.marks = look.marks_out_of_range;
	style.empty = values.empty && !range;
	if (!colors.categories.empty())
		return style;
	style.lines = roundLevels(style.lo, style.hi, lines, style.logarithmic);
	style.bands = roundLevels(style.lo, style.hi, look.bands, style.logarithmic);
	return style;
}

// Where lines lie is told by the first legend.
bool looksAlike(const ValueStyle& a, const ValueStyle& b)
{
	return a.lo == b.lo && a.hi == b.hi && a.below == b.below && a.above == b.above && a.bands == b.bands &&
	       (a.colors == b.colors ||
	        (a.colors->colors == b.colors->colors && a.colors->categories == b.colors->categories));
}

} // namespace

Color ValueStyle::belowColor() const
{
	if (marks || colors->marks_below)
		return colors->below;
	return bands.empty() ? colors->colors.front() : bandColor(0);
}

Color ValueStyle::aboveColor() const
{
	if (marks || colors->marks_above)
		return colors->above;
	return bands.empty() ? colors->colors.back() : bandColor(bands.size());
}

Color ValueStyle::bandColor(std::size_t band) const
{
	const double from = band > 0 ? part(bands[band - 1]) : 0.0;
	const double to = band < bands.size() ? part(bands[band]) : 1.0;
	return colors->at(0.5 * (from + to));
}

ValueStyle valueStyle(const Look& look, const ValueScale& values)
{
	return styleOf(look.colors, values, look, look.range, look.lines);
}

ValueStyle valueStyle(const Scene& scene, const SheetDrawing& sheet)
{
	const Look& look = scene.look;
	// A range is that of an array: another array does not take it over.
	const auto& range = sheet.range || sheet.values ? sheet.range : look.range;
	return styleOf(sheet.colors ? *sheet.colors : look.colors, sheet.values ? *sheet.values : *scene.values, look,
	               range, sheet.lines.value_or(look.lines));
}

ValueStyle valueStyle(const Scene& scene, const Surface& surface)
{
	const Look& look = scene.look;
	return styleOf(surface.colors ? *surface.colors : look.colors, *surface.values, look, surface.range,
	               surface.lines.value_or(look.lines));
}

CategorySteps categorySteps(const ColorMap& map)
{
	CategorySteps steps;
	steps.colors.push_back(map.nan);
	for (std::size_t i = 0; i < map.categories.size(); ++i)
	{
		const Category& category = map.categories[i];
		const double before = i > 0 ? category.value - map.categories[i - 1].value : 1.0;
		const double after = i + 1 < map.categories.size() ? map.categories[i + 1].value - category.value : 1.0;
		const double from = category.value - 0.5 * std::min(before, 1.0);
		const double to = category.value + 0.5 * std::min(after, 1.0);
		if (!steps.bounds.empty() && from <= steps.bounds.back())
			steps.colors.back() = category.color; // no gap to the one before
		else
		{
			steps.bounds.push_back(from);
			steps.colors.push_back(category.color);
		}
		steps.bounds.push_back(to);
		steps.colors.push_back(map.nan);
	}
	return steps;
}

namespace
{

// Adds a legend that says something new; one of an array that has one already gets its owner's name.
void addLegend(LegendContent content, const std::string& owner, std::vector<LegendContent>& contents)
{
	const auto same = [&](const LegendContent& other) { return other.title == content.title; };
	if (std::any_of(contents.begin(), contents.end(),
	                [&](const LegendContent& c) { return same(c) && looksAlike(c.style, content.style); }))
		return;
	if (std::any_of(contents.begin(), contents.end(), same))
		content.title += fmt::format(" ({})", owner);
	contents.push_back(std::move(content));
}

} // namespace

std::vector<LegendContent> legendContents(const Scene& scene)
{
	std::vector<LegendContent> contents;
	const auto own = [](const SheetDrawing& sheet) { return sheet.values || sheet.colors || sheet.range; };
	if (scene.values && (scene.sheets.empty() || !std::all_of(scene.sheets.begin(), scene.sheets.end(), own)))
		contents.push_back({scene.values->title, scene.values->has_nan, valueStyle(scene.look, *scene.values)});
	for (std::size_t i = 0; i < scene.sheets.size(); ++i)
	{
		const SheetDrawing& sheet = scene.sheets[i];
		if (!own(sheet) || !(sheet.values || scene.values))
			continue;
		const ValueScale& values = sheet.values ? *sheet.values : *scene.values;
		addLegend({values.title, values.has_nan, valueStyle(scene, sheet)}, fmt::format("sheet {}", i + 1), contents);
	}
	for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
	{
		const Surface& surface = scene.surfaces[i];
		if (surface.values)
			addLegend({surface.values->title, surface.values->has_nan, valueStyle(scene, surface)},
			          surface.name.empty() ? fmt::format("surface {}", i + 1) : surface.name, contents);
	}
	return contents;
}

} // namespace vp::render
