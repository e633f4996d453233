#include "render/passes/value_params.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace vp::render
{

namespace
{

static_assert(shared::kTableColors == kColorMapSize);

// Interpolation rounds; it must not take the ends of the range out of it.
constexpr double kRangeSlack = 1e-5;

std::uint32_t packed(Color c)
{
	return c.r | std::uint32_t(c.g) << 8 | std::uint32_t(c.b) << 16 | std::uint32_t(c.a) << 24;
}

void setRange(shared::SheetParams& sheet, const ValueStyle& style)
{
	const double lo = style.scaled(style.lo);
	const double hi = style.scaled(style.hi);
	const double slack = kRangeSlack * (hi - lo);
	constexpr float kEndless = std::numeric_limits<float>::infinity();
	sheet.below_from = style.below ? static_cast<float>(lo - slack) : -kEndless;
	sheet.above_from = style.above ? static_cast<float>(hi + slack) : kEndless;
	sheet.range_lo = static_cast<float>(lo);
	// A constant has the map's middle.
	const bool constant = !(hi > lo);
	sheet.range_scale = constant ? 0.0f : static_cast<float>(1.0 / (hi - lo));
	sheet.range_offset = constant ? 0.5f : 0.0f;
	sheet.is_log = style.logarithmic ? 1 : 0;
	sheet.is_stepped = style.per_cell ? 1 : 0;
}

std::vector<double> scaled(const std::vector<double>& values, const ValueStyle& style)
{
	std::vector<double> result;
	for (const double value : values)
		result.push_back(style.scaled(value));
	return result;
}

void setSteps(shared::SheetParams& sheet, const ValueStyle& style, ColorTables& tables)
{
	CategorySteps steps;
	if (!style.colors->categories.empty())
	{
		steps = categorySteps(*style.colors);
		sheet.below_from = -std::numeric_limits<float>::infinity();
		sheet.above_from = std::numeric_limits<float>::infinity();
	}
	else if (!style.bands.empty())
	{
		steps.bounds = scaled(style.bands, style);
		for (std::size_t i = 0; i <= style.bands.size(); ++i)
			steps.colors.push_back(style.bandColor(i));
	}
	sheet.step_count = static_cast<std::uint32_t>(steps.bounds.size());
	sheet.step_bounds = tables.add(steps.bounds);
	sheet.step_colors = tables.add(steps.colors);
}

} // namespace

std::uint32_t ColorTables::add(const std::vector<Color>& colors)
{
	const auto place = static_cast<std::uint32_t>(words_.size());
	std::transform(colors.begin(), colors.end(), std::back_inserter(words_), packed);
	return place;
}

std::uint32_t ColorTables::add(const std::vector<double>& numbers)
{
	const auto place = static_cast<std::uint32_t>(words_.size());
	for (const double number : numbers)
		words_.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(number)));
	return place;
}

std::vector<std::uint32_t> ColorTables::take()
{
	add(std::vector<Color>(kColorMapSize));
	return std::move(words_);
}

void setPlain(shared::SheetParams& sheet, Color color)
{
	// Whatever the values are, they lie below this.
	sheet.below_from = std::numeric_limits<float>::infinity();
	sheet.above_from = std::numeric_limits<float>::infinity();
	sheet.below_color = sheet.nan_color = packed(color);
}

void setValues(shared::SheetParams& sheet, const ValueStyle& style, ColorTables& tables)
{
	const ColorMap& map = *style.colors;
	setRange(sheet, style);
	setSteps(sheet, style, tables);
	sheet.colors = tables.add(std::vector<Color>(map.colors.begin(), map.colors.end()));
	sheet.level_count = static_cast<std::uint32_t>(style.lines.size());
	sheet.levels = tables.add(scaled(style.lines, style));
	sheet.nan_color = packed(map.nan);
	sheet.below_color = packed(style.belowColor());
	sheet.above_color = packed(style.aboveColor());
}

std::uint32_t featuresOf(const shared::SheetParams& sheet)
{
	return (sheet.level_count > 0 ? shared::kComposeLines : 0u) | (sheet.step_count > 0 ? shared::kComposeSteps : 0u) |
	       (sheet.is_log != 0 ? shared::kComposeLog : 0u);
}

} // namespace vp::render
