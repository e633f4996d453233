#pragma once

#include "render/annotate/font_atlas.h"
#include "render/annotate/layout.h"
#include "render/color/color_map.h"

#include <string>
#include <vector>

namespace vp::render
{

// Dark on light, light on dark.
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

Color groundOf(const Background& background); // its middle; white where it is transparent

// Of lines on a color: dark on light, light on dark.
Color inkOver(const Color& under);

// Width of the halo about letters, in em.
constexpr double kHalo = 0.16;

// Writes and draws in pixels; y runs down.
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
	// Turned clockwise by an angle in radians about its middle, with a halo that parts it from what is below; one of
	// alpha 0 is left out.
	virtual void turnedText(const glm::dvec2& center, double angle, double size, Color color, Color halo,
	                        const std::string& words) = 0;
	virtual void line(const glm::dvec2& a, const glm::dvec2& b, Color color, double width) = 0;
	virtual void closedLine(const std::vector<glm::dvec2>& corners, Color color, double width) = 0;
	virtual void filled(const std::vector<glm::dvec2>& convex, Color color) = 0;
	virtual void filled(const Area& area, Color color) = 0; // areas side by side leave no gap
	virtual void dot(const glm::dvec2& center, double radius, Color color) = 0;
	virtual void colorBar(const Area& bar, const ColorMap& colors) = 0; // its low end below

	// Text beside a mark: vertically centered on it.
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
