#include "viewer/panels/color_maps.h"

#include "render/color/color_map_file.h"

#include <map>
#include <optional>

namespace vp::app
{

namespace
{

constexpr int kSteps = 32; // steps of a gradient
constexpr std::string_view kReverse = "_r";

ImU32 inked(const render::Color& color)
{
	return IM_COL32(color.r, color.g, color.b, 255);
}

} // namespace

const render::ColorMap* colorMapOf(const std::string& word)
{
	static std::map<std::string, std::optional<render::ColorMap>> known;
	auto found = known.find(word);
	if (found == known.end())
	{
		Result<render::ColorMap> map = render::chooseColorMap(word);
		found = known.emplace(word, map ? std::optional(std::move(*map)) : std::nullopt).first;
	}
	return found->second ? &*found->second : nullptr;
}

bool isReversed(const std::string& word)
{
	return word.ends_with(kReverse);
}

std::string otherWay(const std::string& word)
{
	return isReversed(word) ? word.substr(0, word.size() - kReverse.size()) : word + std::string(kReverse);
}

void drawGradient(ImDrawList& list, const render::ColorMap& map, const ImVec2& lo, const ImVec2& hi)
{
	const int parts = map.categories.empty() ? kSteps : static_cast<int>(map.categories.size());
	const auto at = [&](int step)
	{ return lo.x + (hi.x - lo.x) * static_cast<float>(step) / static_cast<float>(parts); };
	for (int i = 0; i < parts; ++i)
	{
		const ImU32 from = map.categories.empty() ? inked(map.at(static_cast<double>(i) / parts))
		                                          : inked(map.categories[static_cast<std::size_t>(i)].color);
		const ImU32 to = map.categories.empty() ? inked(map.at(static_cast<double>(i + 1) / parts)) : from;
		list.AddRectFilledMultiColor({at(i), lo.y}, {at(i + 1), hi.y}, from, to, to, from);
	}
}

} // namespace vp::app
