#include "render/annotate/canvas.h"

#include <algorithm>
#include <cmath>

namespace vp::render
{

namespace
{

constexpr Inks kOnLight{{38, 43, 50}, {92, 99, 108}, {196, 48, 43}, {38, 132, 66}, {38, 92, 190}};
constexpr Inks kOnDark{{236, 238, 241}, {172, 178, 186}, {255, 116, 106}, {110, 209, 130}, {122, 168, 255}};
constexpr double kThin = 0.6; // opacity of thin lines

std::vector<glm::dvec2> cornersOf(const Area& area)
{
	return {area.lo, {area.hi.x, area.lo.y}, area.hi, {area.lo.x, area.hi.y}};
}

} // namespace

Inks inksOn(const Background& background)
{
	return background.dark() ? kOnDark : kOnLight;
}

double luminance(const Color& color)
{
	return (0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b) / 255.0;
}

Color groundOf(const Background& background)
{
	if (background.transparent())
		return {255, 255, 255};
	const Color& top = background.top;
	const Color& bottom = background.bottom;
	return colorOf(Vec3(top.r + bottom.r, top.g + bottom.g, top.b + bottom.b) / 510.0);
}

Color inkOver(const Color& under)
{
	const std::uint8_t ink = luminance(under) < 0.33 ? 235 : 18;
	return {ink, ink, ink, 190};
}

double Canvas::hairline() const
{
	return std::max(1.0, em_ / 16.0);
}

Color Canvas::thin() const
{
	Color color = inks_.text;
	color.a = static_cast<std::uint8_t>(std::lround(kThin * color.a));
	return color;
}

void Canvas::label(double x, double y, const std::string& words)
{
	text({x, y - 0.5 * em_}, em_, inks_.text, words);
}

void Canvas::line(const glm::dvec2& a, const glm::dvec2& b)
{
	line(a, b, thin(), hairline());
}

void Canvas::framed(const std::vector<glm::dvec2>& corners)
{
	closedLine(corners, thin(), hairline());
}

void Canvas::framed(const Area& area)
{
	framed(cornersOf(area));
}

} // namespace vp::render
