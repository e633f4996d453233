#pragma once

#include "base/result.h"
#include "render/color/color_map.h"
#include "render/font/typeface.h"
#include "render/scene/outline.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace vp::render
{

constexpr std::uint32_t kMaxPictureSize = 16384; // longest side, pixels; a device may have a lower limit
constexpr int kMaxSamples = 256;

// The background of the scene: a gradient from top to bottom, a plain color (both colors are equal), or nothing (alpha
// 0).
struct Background
{
	Color top{253, 253, 254};
	Color bottom{228, 231, 235};

	bool transparent() const { return top.a == 0 && bottom.a == 0; }
	bool dark() const; // if so, lines and letters are light
	bool operator==(const Background&) const = default;
};

// Returns the color of a text: `white`, `black`, `grey` or `gray`, #RGB or #RRGGBB. Returns nothing for any other text.
std::optional<Color> parseColor(std::string_view text);

// Returns the background of a text: `gradient`, `white`, `black`, `gray`, `transparent`, #RGB or #RRGGBB. Any other
// text is a usage error, which does not name the setting.
Result<Background> parseBackground(std::string_view text);
std::string backgroundText(const Background& background); // parseBackground() returns the same background again

// Returns the size of a text WxH in pixels. The usage error does not name the setting.
Result<std::pair<std::uint32_t, std::uint32_t>> parseSize(std::string_view text);

constexpr double kMinTextSize = 4.0; // pixels
constexpr double kMaxTextSize = 500.0;

// Returns the size of text in pixels: of `12`, `12px` or `9pt`, where a point is 4/3 of a pixel, as on a page. The
// usage error names neither the setting nor the text.
Result<double> parseTextSize(std::string_view text);

// The settings of a picture that a user can change.
struct Look
{
	std::uint32_t width = 1280;
	std::uint32_t height = 720;
	int samples = 8; // per pixel
	ColorMap colors = makeColorMap("viridis").value();
	std::optional<std::pair<double, double>> range; // range of the colors; empty: the range of the data
	bool marks_out_of_range = false; // values outside the range get colors of their own instead of those of its ends
	bool logarithmic = false;        // colors follow the logarithm of the values
	int lines = 0;                   // about this number of contour lines, at round values
	int bands = 0;                   // about this number of bounds between bands of one color, at round values
	bool mesh = false;               // the polygons' edges
	bool lit = false;                // sheets are darker if they are seen from the side
	Background background;
	bool labels = true;       // values on contour lines
	std::string length_units; // on axes, behind their names; empty: none
	std::string title;
	std::string caption;
	double text_size = 0.0; // em of plain text, pixels; 0: it follows from the size of the picture
	const Typeface* font = &Typeface::builtIn();
	Outline outline = Outline::box;
	bool legend = true;
	bool axes = true;                                     // the directions of x, y and z, in the lower left corner
	std::array<std::string, 3> axis_names{"x", "y", "z"}; // there; of a patient: the sides that the axes run to
	bool small_view = true;                               // beside a flat picture: where the sheet lies in the grid
	bool box_axes = false;                                // numbers along edges of the scene's bounds
};

} // namespace vp::render
