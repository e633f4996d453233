#include "render/pen.h"

#include <algorithm>
#include <cmath>

namespace vp::render
{

namespace
{

constexpr Inks kOnLight{{38, 43, 50}, {92, 99, 108}, {196, 48, 43}, {38, 132, 66}, {38, 92, 190}};
constexpr Inks kOnDark{{236, 238, 241}, {172, 178, 186}, {255, 116, 106}, {110, 209, 130}, {122, 168, 255}};
constexpr double kThin = 0.6; // opacity of thin lines

ImU32 packed(Color c, double opacity = 1.0)
{
	return IM_COL32(c.r, c.g, c.b, static_cast<int>(std::lround(opacity * c.a)));
}

ImVec2 at(const glm::dvec2& p)
{
	return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

std::vector<ImVec2> at(const std::vector<glm::dvec2>& points)
{
	std::vector<ImVec2> result;
	for (const glm::dvec2& p : points)
		result.push_back(at(p));
	return result;
}

} // namespace

Inks inksOn(const Background& background)
{
	return background.dark() ? kOnDark : kOnLight;
}

Pen::Pen(const Lettering& lettering, const Inks& inks, double em)
    : lettering_(lettering), inks_(inks), em_(em), list_(lettering.shared())
{
	list_._ResetForNewFrame();
	list_.PushClipRectFullScreen();
	list_.PushTextureID(nullptr);
}

float Pen::hairline() const
{
	return static_cast<float>(std::max(1.0, em_ / 16.0));
}

void Pen::text(const glm::dvec2& top_left, double size, Color color, const std::string& words)
{
	const glm::dvec2 pixel = glm::round(top_left);
	list_.AddText(lettering_.font(size), static_cast<float>(size), at(pixel), packed(color), words.data(),
	              words.data() + words.size());
}

void Pen::label(double x, double y, const std::string& words)
{
	text({x, y - 0.5 * em_}, em_, inks_.text, words);
}

void Pen::line(const glm::dvec2& a, const glm::dvec2& b)
{
	list_.AddLine(at(a), at(b), packed(inks_.text, kThin), hairline());
}

void Pen::line(const glm::dvec2& a, const glm::dvec2& b, Color color, double width)
{
	list_.AddLine(at(a), at(b), packed(color), static_cast<float>(width));
}

void Pen::filled(const std::vector<glm::dvec2>& convex, Color color)
{
	const auto corners = at(convex);
	list_.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), packed(color));
}

void Pen::filled(const Area& area, Color top, Color bottom)
{
	list_.AddRectFilledMultiColor(at(area.lo), at(area.hi), packed(top), packed(top), packed(bottom), packed(bottom));
}

void Pen::framed(const std::vector<glm::dvec2>& corners)
{
	const auto points = at(corners);
	list_.AddPolyline(points.data(), static_cast<int>(points.size()), packed(inks_.text, kThin), ImDrawFlags_Closed,
	                  hairline());
}

void Pen::framed(const Area& area)
{
	list_.AddRect(at(area.lo), at(area.hi), packed(inks_.text, kThin), 0.0f, 0, hairline());
}

void Pen::dot(const glm::dvec2& centre, double radius, Color color)
{
	list_.AddCircleFilled(at(centre), static_cast<float>(radius), packed(color));
}

} // namespace vp::render
