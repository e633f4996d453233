#include "render/passes/layer_colors.h"

#include <array>
#include <cmath>

namespace vp::render
{

namespace
{

using Channels = std::array<float, 4>; // 0 to 1

Channels unpacked(std::uint32_t color)
{
	Channels channels;
	for (int c = 0; c < 4; ++c)
		channels[c] = static_cast<float>(color >> 8 * c & 0xFFu) / 255.0f;
	return channels;
}

void add(LayerColors& to, const shared::SheetParams& sheet, const Channels& color)
{
	for (int c = 0; c < 4; ++c)
		to.push_back(static_cast<std::uint16_t>(65535.0f * color[c] * (c < 3 ? sheet.shade : sheet.opacity) + 0.5f));
}

// Between the colors of the table, t from 0 to 1.
Channels tableColorAt(const std::uint32_t* table, float t)
{
	const float place = t * static_cast<float>(shared::kTableColors - 1);
	const auto low = std::min(static_cast<std::uint32_t>(place), shared::kTableColors - 2);
	const Channels a = unpacked(table[low]);
	const Channels b = unpacked(table[low + 1]);
	Channels mixed;
	for (int c = 0; c < 4; ++c)
		mixed[c] = std::lerp(a[c], b[c], place - static_cast<float>(low));
	return mixed;
}

} // namespace

std::uint32_t addLayerColors(LayerColors& to, const shared::SheetParams& sheet,
                             const std::vector<std::uint32_t>& tables)
{
	const auto place = static_cast<std::uint32_t>(to.size() / 4);
	for (const std::uint32_t color : {sheet.below_color, sheet.above_color, sheet.nan_color})
		add(to, sheet, unpacked(color));
	if (sheet.step_count > 0)
		for (std::uint32_t i = 0; i <= sheet.step_count; ++i)
			add(to, sheet, unpacked(tables[sheet.step_colors + i]));
	else
		for (std::uint32_t i = 0; i < shared::kLayerRangeColors; ++i)
			add(to, sheet,
			    tableColorAt(&tables[sheet.colors], static_cast<float>(i) / (shared::kLayerRangeColors - 1)));
	return place;
}

} // namespace vp::render
