#include "render/color/preset_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <utility>

namespace vp::render
{

namespace
{

using nlohmann::json;

// Red, green and blue from 0 to 1.
json channelsOf(const Color& color)
{
	return {color.r / 255.0, color.g / 255.0, color.b / 255.0};
}

void putCategories(const ColorMap& map, json& preset)
{
	for (const Category& category : map.categories)
	{
		for (const json& part : channelsOf(category.color))
			preset["IndexedColors"].push_back(part);
		preset["Annotations"].push_back(fmt::format("{}", category.value));
		preset["Annotations"].push_back(category.name);
	}
}

void putColorPoints(const ColorMap& map, const OpacityPoints& points, json& preset)
{
	json colors = json::array();
	json opacities = json::array();
	bool is_opaque = true;
	for (int i = 0; i < kColorMapSize; ++i)
	{
		const Color& color = map.colors[i];
		const double x = double(i) / (kColorMapSize - 1);
		colors.push_back(x);
		for (const json& part : channelsOf(color))
			colors.push_back(part);
		is_opaque = is_opaque && color.a == 255;
		if (points.empty())
			for (const double number : {x, color.a / 255.0, 0.5, 0.0})
				opacities.push_back(number);
	}
	for (const OpacityPoint& point : points)
		for (const double number : {point.place, point.opacity, 0.5, 0.0})
			opacities.push_back(number);
	preset["ColorSpace"] = "RGB";
	preset["RGBPoints"] = std::move(colors);
	if (!points.empty() || !is_opaque)
		preset["Points"] = std::move(opacities);
}

} // namespace

std::string presetText(const ColorMap& map, const OpacityPoints& points)
{
	json preset{{"Name", map.name},
	            {"NanColor", channelsOf(map.nan)},
	            {"BelowRangeColor", channelsOf(map.below)},
	            {"UseBelowRangeColor", map.marks_below ? 1 : 0},
	            {"AboveRangeColor", channelsOf(map.above)},
	            {"UseAboveRangeColor", map.marks_above ? 1 : 0}};
	if (map.categories.empty())
		putColorPoints(map, points, preset);
	else
		putCategories(map, preset);
	return json::array({std::move(preset)}).dump(1, '\t', false, json::error_handler_t::replace) + "\n";
}

} // namespace vp::render
