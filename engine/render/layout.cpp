#include "render/layout.h"

#include "render/value_style.h"

#include <algorithm>
#include <cmath>

namespace vp::render
{

namespace
{

// DejaVu Sans: a digit is 0.636 em wide, wider than points, signs of numbers and most letters.
constexpr double kDigitWidth = 0.64;
constexpr double kLetterWidth = 0.60;
constexpr double kLineHeight = 1.25;

constexpr double kSmallestText = 9.0;     // pixels; DejaVu is legible from there
constexpr double kLongestTitleLine = 9.0; // of the legend, em

std::size_t letters(const std::string& utf8)
{
	return static_cast<std::size_t>(std::count_if(
	    utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

constexpr double kLongestBar = 32.0;       // em
constexpr double kWidestCategories = 15.0; // em

Ticks legendTicks(const ValueStyle& style, int most)
{
	const std::vector<double>& levels = style.bands.empty() ? style.lines : style.bands;
	if (!levels.empty())
		return ticksAt(levels, most, style.logarithmic);
	return style.logarithmic ? makeLogTicks(style.lo, style.hi, most) : makeTicks(style.lo, style.hi, most);
}

// Fewer categories than there is room for make a short column.
void layOutCategories(const ColorMap& map, double top, double& bottom, Layout& layout)
{
	layout.entry = 1.45 * layout.em;
	const auto room = static_cast<std::size_t>(std::max(1.0, (bottom - top) / layout.entry));
	layout.categories = map.categories.size() <= room ? map.categories.size() : room - 1;
	bottom = top + layout.entry * static_cast<double>(std::min(room, map.categories.size()));
}

std::size_t longestLabel(const ColorMap& map, const Layout& layout)
{
	std::size_t longest = std::max<std::size_t>(3, letters(layout.ticks.factor)); // "NaN"
	for (const Tick& tick : layout.ticks.marks)
		longest = std::max(longest, letters(tick.label));
	for (std::size_t i = 0; i < layout.categories; ++i)
		longest = std::max(longest, letters(map.categories[i].name));
	return layout.categories < map.categories.size() ? std::max<std::size_t>(longest, 9) : longest; // "… 99 more"
}

void layOutLegend(const Look& look, const ValueScale& values, Layout& layout)
{
	const double em = layout.em;
	const double height = look.height;
	const ValueStyle style = valueStyle(look, values);
	const bool categories = !look.colors.categories.empty();

	layout.cap = style.below || style.above ? 0.9 * em : 0.0;
	const double title_lines = 2.0; // a third grows upwards
	const double half = std::min(0.34 * height, 0.5 * kLongestBar * em);
	const double top = std::max(0.5 * height - half, layout.margin + kLineHeight * em * (title_lines + 2.5));
	double bottom = std::min(0.5 * height + half, height - layout.margin - 3.2 * em);
	if (categories)
	{
		layout.cap = 0.0;
		layOutCategories(look.colors, top, bottom, layout);
	}
	else
		layout.ticks = legendTicks(style, std::clamp(static_cast<int>((bottom - top) / (2.5 * em)), 2,
		                                             style.lines.empty() && style.bands.empty() ? 9 : 16));

	const double bar_width = 1.1 * em;
	const double labels =
	    bar_width + 0.6 * em + kDigitWidth * em * static_cast<double>(longestLabel(look.colors, layout));
	const double title =
	    std::min(kLetterWidth * em * static_cast<double>(letters(values.title)), kLongestTitleLine * em);
	const double widest = categories ? std::min(kWidestCategories * em, 0.3 * look.width) : 0.4 * look.width;
	const double column = std::min(std::max(labels, title), widest);

	const double right = look.width - layout.margin;
	const double left = right - column;
	layout.bar = {{left, top}, {left + bar_width, bottom}};
	const double factor_height = layout.ticks.factor.empty() ? 0.0 : kLineHeight * em;
	const double factor_bottom = top - layout.cap - 0.45 * em;
	layout.factor = {{left, factor_bottom - factor_height}, {right, factor_bottom}};
	layout.legend_title = {{left, std::max(layout.margin, layout.factor.lo.y - 3.0 * kLineHeight * em)},
	                       {right, layout.factor.lo.y}};
	if (values.has_nan)
	{
		const double y = bottom + layout.cap + 0.8 * em;
		layout.nan = {{left, y}, {left + bar_width, y + em}};
	}
	layout.legend = {{left, layout.legend_title.lo.y},
	                 {right, values.has_nan ? layout.nan.hi.y + 0.2 * em : bottom + layout.cap + 0.5 * em}};
}

} // namespace

Layout makeLayout(const Look& look, const std::optional<ValueScale>& values)
{
	const double width = look.width;
	const double height = look.height;
	Layout layout{};
	// Whole pixels keep the letters' stems sharp.
	layout.em = std::max(kSmallestText, std::round(std::min(height / 44.0, width / 48.0)));
	layout.title_em = std::round(1.3 * layout.em);
	layout.small_em = std::max(kSmallestText, std::round(0.85 * layout.em));
	layout.margin = std::round(1.1 * layout.em);

	double right = width - layout.margin;
	if (look.legend && values)
	{
		layOutLegend(look, *values, layout);
		right = layout.legend.lo.x - 1.5 * layout.margin;
	}
	double top = layout.margin;
	if (!look.title.empty())
	{
		layout.title = {{layout.margin, layout.margin}, {right, layout.margin + kLineHeight * layout.title_em}};
		top = layout.title.hi.y + 0.3 * layout.margin;
	}
	if (look.axes)
	{
		const double side = 5.4 * layout.em;
		layout.axes = {{0.6 * layout.margin, height - 0.6 * layout.margin - side},
		               {0.6 * layout.margin + side, height - 0.6 * layout.margin}};
	}
	double bottom = height - layout.margin;
	if (!look.caption.empty())
	{
		const double left = look.axes ? layout.axes.hi.x + layout.margin : layout.margin;
		const double base = height - 0.7 * layout.margin;
		layout.caption = {{left, base - kLineHeight * layout.small_em}, {right, base}};
		bottom = layout.caption.lo.y - 0.5 * layout.margin;
	}

	layout.frame.width = width;
	layout.frame.height = height;
	layout.frame.free_lo = {layout.margin, top};
	layout.frame.free_hi = {std::max(right, layout.margin + 0.25 * width), std::max(bottom, top + 0.25 * height)};
	if (look.box_axes)
	{
		// Numbers of usual length, and the axes' names, find room around the box.
		const glm::dvec2 room =
		    glm::min(glm::dvec2(4.6, 3.0) * layout.em, 0.2 * (layout.frame.free_hi - layout.frame.free_lo));
		layout.frame.free_lo += room;
		layout.frame.free_hi -= room;
	}
	if (look.axes)
		layout.frame.corner = {layout.axes.hi.x, layout.axes.lo.y};
	return layout;
}

Frame pictureFrame(const Look& look, const std::optional<ValueScale>& values)
{
	return makeLayout(look, values).frame;
}

} // namespace vp::render
