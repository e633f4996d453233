#pragma once

#include "base/result.h"
#include "render/color/color_map.h"
#include "render/scene/outline.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace vp::render
{

constexpr std::uint32_t kMaxPictureSize = 16384; // a side, pixels; a device may take less
constexpr int kMaxSamples = 256;

// Behind the scene: a gradient from top to bottom, a plain color (both alike), or nothing (alpha 0).
struct Background
{
	Color top{253, 253, 254};
	Color bottom{228, 231, 235};

	bool transparent() const { return top.a == 0 && bottom.a == 0; }
	bool dark() const; // lines and letters are light then
	bool operator==(const Background&) const = default;
};

// `white`, `black`, `gray`, #RGB or #RRGGBB; none where the text is no color.
std::optional<Color> parseColor(std::string_view text);

// `gradient`, `white`, `black`, `gray`, `transparent`, #RGB or #RRGGBB; anything else is a usage error, which does not
// name the setting.
Result<Background> parseBackground(std::string_view text);
std::string backgroundText(const Background& background); // read again it is the same

// WxH in pixels; the usage error does not name the setting.
Result<std::pair<std::uint32_t, std::uint32_t>> parseSize(std::string_view text);

// What a user sets about a picture.
struct Look
{
	std::uint32_t width = 1280;
	std::uint32_t height = 720;
	int samples = 8; // per pixel
	ColorMap colors = makeColorMap("viridis").value();
	std::optional<std::pair<double, double>>
	    range;                // of the colors; values beyond it get colors of their own. Else the data's.
	bool logarithmic = false; // colors follow the values' logarithm
	int lines = 0;            // about so many contour lines, at round values
	int bands = 0;            // bands of one color, about so many bounds between them, at round values
	bool mesh = false;        // the polygons' edges
	bool lit = false;         // sheets are darker the more they are seen from the side
	Background background;
	bool labels = true;       // values on contour lines
	std::string length_units; // on axes, behind their names; empty: not told
	std::string title;
	std::string caption;
	Outline outline = Outline::box;
	bool legend = true;
	bool axes = true;      // where x, y and z point, in the lower left corner
	bool box_axes = false; // numbers along edges of the scene's bounds
};

} // namespace vp::render
