#pragma once

#include "render/annotate/canvas.h"

typedef struct _cairo cairo_t;

namespace vp::render
{

// A canvas on any surface of cairo, with the fonts of FontAtlas.
class CairoCanvas final : public Canvas
{
public:
	// The context must outlive the canvas.
	CairoCanvas(cairo_t* context, const FontAtlas& lettering, const Inks& inks, double em);

	cairo_t* context() const { return context_; }
	void setColor(Color color);
	void path(const std::vector<glm::dvec2>& points, bool closed); // adds to cairo's path
	void stroke(Color color, double width);                        // strokes cairo's path, with round joins and ends

	using Canvas::line;
	void text(const glm::dvec2& top_left, double size, Color color, const std::string& words) override;
	void turnedText(const glm::dvec2& center, double angle, double size, Color color, Color halo,
	                const std::string& words) override;
	void line(const glm::dvec2& a, const glm::dvec2& b, Color color, double width) override;
	void closedLine(const std::vector<glm::dvec2>& corners, Color color, double width) override;
	void filled(const std::vector<glm::dvec2>& convex, Color color) override;
	void filled(const Area& area, Color color) override;
	void dot(const glm::dvec2& center, double radius, Color color) override;
	void colorBar(const Area& bar, const ColorMap& colors) override;

private:
	void show(const std::string& words);
	double advance(const std::string& words); // width of a text

	cairo_t* context_;
};

} // namespace vp::render
