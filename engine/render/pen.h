#pragma once

#include "render/color_map.h"
#include "render/layout.h"
#include "render/lettering.h"

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

// Writes and draws in pixels into one of ImGui's draw lists.
class Pen
{
public:
	Pen(const Lettering& lettering, const Inks& inks, double em);

	const Inks& inks() const { return inks_; }
	const Lettering& lettering() const { return lettering_; }
	double em() const { return em_; }
	const ImDrawList& list() const { return list_; }

	void text(const glm::dvec2& top_left, double size, Color color, const std::string& words);
	// Text beside a mark: vertically centred on it.
	void label(double x, double y, const std::string& words);
	void line(const glm::dvec2& a, const glm::dvec2& b); // thin
	void line(const glm::dvec2& a, const glm::dvec2& b, Color color, double width);
	void filled(const std::vector<glm::dvec2>& convex, Color color);
	void filled(const Area& area, Color top, Color bottom);
	void framed(const std::vector<glm::dvec2>& corners); // a thin line around
	void framed(const Area& area);
	void dot(const glm::dvec2& centre, double radius, Color color);

private:
	float hairline() const;

	const Lettering& lettering_;
	Inks inks_;
	double em_;
	ImDrawList list_;
};

} // namespace vp::render
