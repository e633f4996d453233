#include "render/color/color_map_list.h"

namespace vp::render
{

ColorMap gray()
{
	ColorMap map;
	for (int i = 0; i < kColorMapSize; ++i)
	{
		const auto level = static_cast<std::uint8_t>(i);
		map.colors[i] = {level, level, level};
	}
	return map;
}

} // namespace vp::render
