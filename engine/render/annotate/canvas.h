#pragma once

#include "render/annotate/font_atlas.h"
#include "render/annotate/layout.h"
#include "render/color/color_map.h"

#include <string>
#include <vector>

namespace vp::render
{

// Colors of text: dark on a light ground, light on a dark one.
struct Inks
{
	Color text;
	Color faint; // captions
	Color x;
	Color y;
	Color z;
};
Inks inksOn(const Background& background);

double luminance(const Color& color); // 0 to 1

Color groundOf(const Background& background); // its middle; white if it is transparent

// Returns the color of lines on a ground: dark on a light one, light on a dark one.
Color inkOver(const Color& under);

// Width of the halo around letters, in em.
constexpr double kHalo = 0.16;

// A surface for text and lines, in pixels with y down.
class Canvas
{
public:
	Canvas(const FontAtlas& lettering, const Inks& inks, double em) : lettering_(lettering), inks_(inks), em_(em) {}
	virtual ~Canvas() = default;
	Canvas(const Canvas&) = delete;
	Canvas& operator=(const Canvas&) = delete;

	const Inks& inks() const { return inks_; }
	const FontAtlas& lettering() const { return lettering_; }
	double em() const { return em_; }

	virtual void text(const glm::dvec2& top_left, double size, Color color, const std::string& words) = 0;
	// Writes text that is turned clockwise about its middle by an angle in radians. A halo separates it from what is
	// below; a halo with alpha 0 is left out.
	virtual void turnedText(const glm::dvec2& center, double angle, double size, Color color, Color halo,
	                        const std::string& words) = 0;
	virtual void line(const glm::dvec2& a, const glm::dvec2& b, Color color, double width) = 0;
	virtual void closedLine(const std::vector<glm::dvec2>& corners, Color color, double width) = 0;
	virtual void filled(const std::vector<glm::dvec2>& convex, Color color) = 0;
	virtual void filled(const Area& area, Color color) = 0; // no gap remains between areas that touch
	virtual void dot(const glm::dvec2& center, double radius, Color color) = 0;
	virtual void colorBar(const Area& bar, const ColorMap& colors) = 0; // the low end is below

	// Writes text beside a mark, vertically centered on it.
	void label(double x, double y, const std::string& words);
	void line(const glm::dvec2& a, const glm::dvec2& b); // thin
	void framed(const std::vector<glm::dvec2>& corners); // a thin line around
	void framed(const Area& area);

private:
	double hairline() const;
	Color thin() const;

	const FontAtlas& lettering_;
	Inks inks_;
	double em_;
};

} // namespace vp::render
