#include "render/flat/flat_layout.h"

#include "measure/plane_triangles.h"
#include "render/annotate/legend_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::render
{

namespace
{

constexpr double kSmallView = 14.0;   // em, at most
constexpr double kMinSmallView = 4.0; // em; the axes' names take 3.2 of it
constexpr double kAroundData = 0.02;  // share of its size that stays free around a slice without a window
constexpr double kNumberWidth = 4.5;  // em, between numbers of the horizontal axis
constexpr double kNumberHeight = 2.4; // em, between numbers of the upright axis
constexpr double kMinRest = 12.0;     // em, least width of a plot and its numbers beside a legend
constexpr int kMaxTickNumbers = 12;

// Returns the area that is shown: the window, else the area of the slice, else the area of the bounds.
Area shownArea(const FlatScene& flat)
{
	if (const auto& window = flat.content.window)
		return {{window->x0, window->y0}, {window->x1, window->y1}};
	std::vector<glm::dvec2> points = measure::planePoints(*flat.mesh, flat.content);
	if (points.empty() && flat.scene.bounds)
		for (int i = 0; i < 8; ++i)
		{
			const Vec3 at = corner(*flat.scene.bounds, i) - flat.content.origin;
			points.emplace_back(glm::dot(at, flat.content.xAxis()), glm::dot(at, flat.content.up));
		}
	Area area{glm::dvec2(-0.5), glm::dvec2(0.5)};
	if (!points.empty())
		area = {points.front(), points.front()};
	for (const glm::dvec2& p : points)
		area = {glm::min(area.lo, p), glm::max(area.hi, p)};
	const double larger = std::max({area.size().x, area.size().y, 1e-300});
	// A slice that is a line or a point has a picture too.
	const glm::dvec2 least = glm::max(glm::dvec2(0.0), 0.5 * (glm::dvec2(1e-3 * larger) - area.size()));
	return {area.lo - least - kAroundData * larger, area.hi + least + kAroundData * larger};
}

void setTicks(PlaneAxis& axis, double lo, double hi, double room, double each)
{
	const int most = std::clamp(static_cast<int>(room / each), 2, kMaxTickNumbers);
	axis.ticks = makeTicks(axis.at_origin + axis.sign * lo, axis.at_origin + axis.sign * hi, most, kNarrowestAxis);
}

double widest(const Ticks& ticks, const FontAtlas& lettering, double em)
{
	double width = 0.0;
	for (const Tick& tick : ticks.marks)
		width = std::max(width, lettering.width(tick.label, em));
	return width;
}

// In the part of the picture above `bottom`, moved left so that it begins where the small view does at the latest.
void layOutLegendsAbove(double bottom, double left, const Look& look, const std::vector<LegendContent>& legends,
                        Layout& text)
{
	Look upper = look;
	upper.height = static_cast<std::uint32_t>(std::max(1.0, bottom));
	layOutLegends(upper, legends, text);
	if (text.legends.empty())
		return;
	if (std::min(left, text.legends.front().column.lo.x) < kMinRest * text.em)
		return text.legends.clear();
	const double shift = std::max(0.0, text.legends.front().column.lo.x - left);
	for (LegendLayout& legend : text.legends)
		for (Area* area : {&legend.bar, &legend.nan, &legend.factor, &legend.title, &legend.column})
			area->lo.x -= shift, area->hi.x -= shift;
}

// The legend above, the small view below, at the right; gives where the rest ends.
double layOutColumn(const FlatScene& flat, const std::vector<LegendContent>& legends, FlatLayout& layout)
{
	const Look& look = flat.scene.look;
	Layout& text = layout.text;
	const double right = look.width - text.margin;
	double left = right;
	if (look.small_view && flat.scene.bounds)
	{
		const double side = std::min({kSmallView * text.em, 0.3 * look.width, 0.36 * look.height});
		if (side > kMinSmallView * text.em)
		{
			layout.small = {{right - side, look.height - text.margin - side}, {right, look.height - text.margin}};
			left = layout.small.lo.x;
		}
	}
	if (look.legend && !legends.empty())
	{
		const bool above = layout.small.size().y > 0.0;
		layOutLegendsAbove(above ? layout.small.lo.y : look.height, left, look, legends, text);
		if (text.legends.empty() && above)
		{
			// Where there is no room for both, colors that can be read are worth more.
			layOutLegendsAbove(look.height, right, look, legends, text);
			if (!text.legends.empty())
				layout.small = {}, left = right;
		}
		if (!text.legends.empty())
			left = std::min(left, text.legends.front().column.lo.x);
	}
	return left < right ? left - 1.2 * text.margin : right;
}

} // namespace

PlaneAxis planeAxis(const Vec3& origin, const Vec3& direction, const std::string& units)
{
	const std::string suffix = units.empty() ? "" : fmt::format(" [{}]", units);
	for (int axis = 0; axis < 3; ++axis)
		if (std::abs(direction[axis]) > 1.0 - 1e-12)
			return {std::string(1, static_cast<char>('x' + axis)) + suffix, origin[axis],
			        direction[axis] > 0.0 ? 1.0 : -1.0};
	const auto part = [&](int axis) { return shortNumber(std::round(1000.0 * direction[axis]) / 1000.0); };
	return {fmt::format("from the origin along ({}, {}, {}){}", part(0), part(1), part(2), suffix)};
}

FlatLayout makeFlatLayout(const FlatScene& flat, const std::vector<LegendContent>& legends, const Layout& text,
                          const FontAtlas& lettering)
{
	FlatLayout layout{};
	layout.text = text;
	layout.shown = shownArea(flat);
	const double em = text.em;
	const std::string& units = flat.scene.look.length_units;
	layout.axes = {planeAxis(flat.content.origin, flat.content.xAxis(), units),
	               planeAxis(flat.content.origin, flat.content.up, units)};
	const double right = layOutColumn(flat, legends, layout);
	layout.text.title.hi.x = layout.text.caption.hi.x = right;

	const double beside = (kFlatTick + 2.0 * kFlatGap + 1.25) * em; // width of an axis without its numbers
	const glm::dvec2 half_number(1.2 * em, 0.5 * em);               // half a number at the far ends
	Area free = {{text.frame.free_lo.x + beside, text.frame.free_lo.y + half_number.y},
	             {right - half_number.x, text.frame.free_hi.y - beside - 1.1 * em}};
	PlaneAxis& upright = layout.axes[1];
	setTicks(upright, layout.shown.lo.y, layout.shown.hi.y, free.size().y, kNumberHeight * em);
	free.lo.x += widest(upright.ticks, lettering, em);
	free.hi = glm::max(free.hi, free.lo + 2.0 * em);

	const glm::dvec2 fits = free.size() / layout.shown.size();
	layout.scale = std::min(fits.x, fits.y);
	const glm::dvec2 size = layout.scale * layout.shown.size();
	const glm::dvec2 lo = glm::round(free.lo + 0.5 * (free.size() - size));
	layout.plot = {lo, lo + size};
	setTicks(layout.axes[0], layout.shown.lo.x, layout.shown.hi.x, size.x, kNumberWidth * em);
	setTicks(upright, layout.shown.lo.y, layout.shown.hi.y, size.y, kNumberHeight * em);
	layout.widest_number = widest(upright.ticks, lettering, em);
	return layout;
}

} // namespace vp::render
