#include "render/annotate/legend_layout.h"

#include <algorithm>
#include <cmath>

namespace vp::render
{

namespace
{

// DejaVu Sans: a digit is 0.636 em wide, wider than points, signs of numbers and most letters.
constexpr double kDigitWidth = 0.64;
constexpr double kLetterWidth = 0.60;
constexpr double kWideLetter = 1.45; // width of a Chinese letter, in these widths

constexpr double kLongestTitleLine = 9.0; // longest line of a legend's title, em

// Letters whose first byte is E3 or above are mostly Chinese, Japanese or Korean, which are wider.
std::size_t letters(const std::string& utf8)
{
	double count = 0.0;
	for (const char c : utf8)
	{
		const auto byte = static_cast<unsigned char>(c);
		if ((byte & 0xC0u) != 0x80u)
			count += byte >= 0xE3u ? kWideLetter : 1.0;
	}
	return static_cast<std::size_t>(std::ceil(count));
}

constexpr double kLongestBar = 32.0;       // em
constexpr double kWidestCategories = 15.0; // em
constexpr double kMinLegend = 12.0;        // em of height, of several
constexpr double kMinBar = 3.0;            // em: two marks, or two categories
constexpr double kRoomyBar = 5.0;          // em; before it is shorter, what is around it moves closer
constexpr double kCap = 0.9;               // em
constexpr double kAboveBar = 0.45;         // em, to the factor or the title

// apart: least distance between a label and those of the ends, as a share of the bar.
Ticks legendTicks(const ValueStyle& style, int most, double apart)
{
	if (style.empty)
		return {};
	const std::vector<double>& levels = style.bands.empty() ? style.lines : style.bands;
	Ticks ticks = !levels.empty()     ? ticksAt(levels, most, style.logarithmic)
	              : style.logarithmic ? makeLogTicks(style.lo, style.hi, most)
	                                  : makeTicks(style.lo, style.hi, most);
	addEnds(ticks, style.lo, style.hi, apart, style.logarithmic);
	return ticks;
}

// Fewer categories than there is room for make a short column.
void layOutCategories(const ColorMap& map, double em, double top, double& bottom, LegendLayout& layout)
{
	layout.entry = 1.45 * em;
	const auto room = static_cast<std::size_t>(std::max(1.0, (bottom - top) / layout.entry));
	layout.categories = map.categories.size() <= room ? map.categories.size() : room - 1;
	bottom = top + layout.entry * static_cast<double>(std::min(room, map.categories.size()));
}

std::size_t longestLabel(const ColorMap& map, const LegendLayout& layout)
{
	std::size_t longest = std::max<std::size_t>(3, letters(layout.ticks.factor)); // "NaN"
	for (const Tick& tick : layout.ticks.marks)
		longest = std::max(longest, letters(tick.label));
	for (std::size_t i = 0; i < layout.categories; ++i)
		longest = std::max(longest, letters(map.categories[i].name));
	return layout.categories < map.categories.size() ? std::max<std::size_t>(longest, 9) : longest; // "… 99 more"
}

// The room that a legend may fill, from top to bottom.
struct Slot
{
	double lo;     // highest line of the title
	double bar_lo; // without cap
	double bar_hi;
	bool tight = false; // bar_lo is without a factor above it
};

// In a low picture the title has one line, and the bar all that is left.
Slot tightSlot(const LegendContent& content, const Look& look, const Layout& layout)
{
	const double em = layout.em;
	const bool caps = content.style.colors->categories.empty() && (content.style.below || content.style.above);
	const double ends = caps ? kCap * em : 0.0;
	return {layout.margin, layout.margin + (kLineHeight + kAboveBar) * em + ends,
	        look.height - layout.margin - ends - (content.has_nan ? 2.0 : 0.5) * em, true};
}

// A single legend stands in the middle of the picture's right side, several one below the other.
Slot slotOf(const LegendContent& content, std::size_t number, std::size_t count, const Look& look, const Layout& layout)
{
	const double em = layout.em;
	const double height = look.height;
	const double title_lines = 2.0; // a third grows upwards
	if (count == 1)
	{
		const double half = std::min(0.34 * height, 0.5 * kLongestBar * em);
		const Slot slot{layout.margin,
		                std::max(0.5 * height - half, layout.margin + kLineHeight * em * (title_lines + 2.5)),
		                std::min(0.5 * height + half, height - layout.margin - 3.2 * em)};
		return slot.bar_hi - slot.bar_lo < kRoomyBar * em ? tightSlot(content, look, layout) : slot;
	}
	const double share = (height - 2.0 * layout.margin) / static_cast<double>(count);
	const double lo = layout.margin + share * static_cast<double>(number);
	return {lo, lo + kLineHeight * em * (title_lines + 1.0) + 1.4 * em,
	        lo + share - em * (content.has_nan ? 3.4 : 2.0)};
}

// Without its place from left to right; gives the width of its column, 0 where there is no room for it.
double layOut(const LegendContent& content, const Slot& slot, const Look& look, double em, LegendLayout& layout)
{
	const ValueStyle& style = content.style;
	const ColorMap& map = *style.colors;
	const bool categories = !map.categories.empty();
	double bottom = slot.bar_hi;
	layout.cap = !categories && (style.below || style.above) ? kCap * em : 0.0;
	if (categories)
		layOutCategories(map, em, slot.bar_lo, bottom, layout);
	else
	{
		const double height = std::max(bottom - slot.bar_lo, em);
		const int most =
		    std::clamp(static_cast<int>(height / (2.5 * em)), 2, style.lines.empty() && style.bands.empty() ? 9 : 16);
		const double for_factor = slot.tight ? kLineHeight * em : 0.0;
		layout.ticks = legendTicks(style, most, kLineHeight * em / std::max(height - for_factor, em));
	}

	const double bar_width = 1.1 * em;
	const double factor_height = layout.ticks.factor.empty() ? 0.0 : kLineHeight * em;
	const double top = slot.tight ? slot.bar_lo + factor_height : slot.bar_lo;
	if (slot.bar_hi - top < kMinBar * em)
		return 0.0;
	layout.bar = {{0.0, top}, {bar_width, bottom}};
	const double factor_bottom = top - layout.cap - kAboveBar * em;
	layout.factor = {{0.0, factor_bottom - factor_height}, {0.0, factor_bottom}};
	layout.title = {{0.0, std::max(slot.lo, layout.factor.lo.y - 3.0 * kLineHeight * em)}, {0.0, layout.factor.lo.y}};
	if (content.has_nan)
	{
		const double y = bottom + layout.cap + 0.8 * em;
		layout.nan = {{0.0, y}, {bar_width, y + em}};
	}
	layout.column = {{0.0, layout.title.lo.y},
	                 {0.0, content.has_nan ? layout.nan.hi.y + 0.2 * em : bottom + layout.cap + 0.5 * em}};

	const double labels = bar_width + 0.6 * em + kDigitWidth * em * static_cast<double>(longestLabel(map, layout));
	const double title =
	    std::min(kLetterWidth * em * static_cast<double>(letters(content.title)), kLongestTitleLine * em);
	const double widest = categories ? std::min(kWidestCategories * em, 0.3 * look.width) : 0.4 * look.width;
	if (!categories && labels > widest)
		return 0.0;
	return std::min(std::max(labels, title), widest);
}

} // namespace

void layOutLegends(const Look& look, const std::vector<LegendContent>& contents, Layout& layout)
{
	const auto room =
	    static_cast<std::size_t>(std::max(1.0, (look.height - 2.0 * layout.margin) / (kMinLegend * layout.em)));
	const std::size_t count = std::min(contents.size(), room);
	double column = 0.0;
	for (std::size_t i = 0; i < count; ++i)
	{
		const Slot slot = slotOf(contents[i], i, count, look, layout);
		const double width = layOut(contents[i], slot, look, layout.em, layout.legends.emplace_back());
		column = std::max(column, width);
		if (!(width > 0.0))
		{
			// They stand for the first contents.
			layout.legends.pop_back();
			break;
		}
	}
	const double right = look.width - layout.margin;
	for (LegendLayout& legend : layout.legends)
	{
		for (Area* area : {&legend.bar, &legend.nan, &legend.factor, &legend.title, &legend.column})
		{
			area->lo.x += right - column;
			area->hi.x += right - column;
		}
		legend.factor.hi.x = legend.title.hi.x = legend.column.hi.x = right;
	}
}

} // namespace vp::render
