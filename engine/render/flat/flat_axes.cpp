#include "render/flat/flat_drawing.h"

namespace vp::render
{

namespace
{

std::string titleOf(const PlaneAxis& axis)
{
	return axis.ticks.factor.empty() ? axis.title : axis.title + "  " + axis.ticks.factor;
}

} // namespace

void drawFlatAxes(const FlatLayout& layout, CairoCanvas& pen)
{
	const double em = pen.em();
	const Color ink = pen.inks().text;
	const Area& plot = layout.plot;
	pen.framed(plot);

	const auto& [level, upright] = layout.axes;
	const double numbers = (kFlatTick + kFlatGap) * em; // off the frame
	for (const Tick& tick : level.ticks.marks)
	{
		const double x = layout.pixel({level.coordinate(tick.value), 0.0}).x;
		pen.line({x, plot.hi.y}, {x, plot.hi.y + kFlatTick * em});
		pen.text({x - 0.5 * pen.lettering().width(tick.label, em), plot.hi.y + numbers}, em, ink, tick.label);
	}
	for (const Tick& tick : upright.ticks.marks)
	{
		const double y = layout.pixel({0.0, upright.coordinate(tick.value)}).y;
		pen.line({plot.lo.x, y}, {plot.lo.x - kFlatTick * em, y});
		pen.label(plot.lo.x - numbers - pen.lettering().width(tick.label, em), y, tick.label);
	}

	const std::string below = titleOf(level);
	pen.text({0.5 * (plot.lo.x + plot.hi.x) - 0.5 * pen.lettering().width(below, em),
	          plot.hi.y + numbers + (1.1 + kFlatGap) * em},
	         em, ink, below);
	pen.turnedText({plot.lo.x - numbers - layout.widest_number - (kFlatGap + 0.55) * em, 0.5 * (plot.lo.y + plot.hi.y)},
	               -1.5707963267948966, em, ink, {0, 0, 0, 0}, titleOf(upright));
}

void drawSides(const FlatScene& flat, const FlatLayout& layout, CairoCanvas& pen)
{
	const double size = 1.4 * pen.em();
	const glm::dvec2 lo = layout.plot.lo + size, hi = layout.plot.hi - size;
	const glm::dvec2 middle = 0.5 * (lo + hi);
	const std::array places{glm::dvec2{lo.x, middle.y}, glm::dvec2{hi.x, middle.y}, glm::dvec2{middle.x, hi.y},
	                        glm::dvec2{middle.x, lo.y}};
	for (std::size_t i = 0; i < places.size(); ++i)
		if (!flat.sides[i].empty())
			pen.turnedText(places[i], 0.0, size, {255, 255, 255}, {0, 0, 0, 200}, flat.sides[i]);
}

} // namespace vp::render
