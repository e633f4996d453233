#pragma once

#include "render/annotate/canvas.h"

namespace vp::render
{

// A canvas that writes triangles into a draw list of ImGui.
class DrawListCanvas final : public Canvas
{
public:
	DrawListCanvas(const FontAtlas& lettering, const Inks& inks, double em);

	const ImDrawList& list() const { return list_; }

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
	void write(const glm::dvec2& top_left, double size, Color color, const std::string& words);

	ImDrawList list_;
};

} // namespace vp::render
