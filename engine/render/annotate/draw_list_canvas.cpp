#include "render/annotate/draw_list_canvas.h"

#include <cmath>
#include <numbers>

namespace vp::render
{

namespace
{

constexpr int kHaloSteps = 12;

ImU32 packedForImGui(Color c)
{
	return IM_COL32(c.r, c.g, c.b, c.a);
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

DrawListCanvas::DrawListCanvas(const FontAtlas& lettering, const Inks& inks, double em)
    : Canvas(lettering, inks, em), list_(lettering.shared())
{
	list_._ResetForNewFrame();
	list_.PushClipRectFullScreen();
	list_.PushTextureID(nullptr);
}

void DrawListCanvas::write(const glm::dvec2& top_left, double size, Color color, const std::string& words)
{
	const ImFont* font = lettering().font(size);
	list_.AddText(font, font->FontSize, at(top_left), packedForImGui(color), words.data(), words.data() + words.size());
}

void DrawListCanvas::text(const glm::dvec2& top_left, double size, Color color, const std::string& words)
{
	write(glm::round(top_left), size, color, words);
}

void DrawListCanvas::turnedText(const glm::dvec2& center, double angle, double size, Color color, Color halo,
                                const std::string& words)
{
	const int first = list_.VtxBuffer.Size;
	const glm::dvec2 top_left = glm::round(center) - 0.5 * glm::round(glm::dvec2(lettering().width(words, size), size));
	if (halo.a > 0)
		for (int i = 0; i < kHaloSteps; ++i)
		{
			const double turn = 2.0 * std::numbers::pi * i / kHaloSteps;
			const glm::dvec2 off = kHalo * size * glm::dvec2(std::cos(turn), std::sin(turn));
			write(top_left + off, size, halo, words);
		}
	write(top_left, size, color, words);
	for (int i = first; i < list_.VtxBuffer.Size; ++i)
	{
		ImVec2& p = list_.VtxBuffer[i].pos;
		const glm::dvec2 from = glm::dvec2(p.x, p.y) - center;
		p = at(center + glm::dvec2(std::cos(angle) * from.x - std::sin(angle) * from.y,
		                           std::sin(angle) * from.x + std::cos(angle) * from.y));
	}
}

void DrawListCanvas::line(const glm::dvec2& a, const glm::dvec2& b, Color color, double width)
{
	list_.AddLine(at(a), at(b), packedForImGui(color), static_cast<float>(width));
}

void DrawListCanvas::closedLine(const std::vector<glm::dvec2>& corners, Color color, double width)
{
	const auto points = at(corners);
	list_.AddPolyline(points.data(), static_cast<int>(points.size()), packedForImGui(color), ImDrawFlags_Closed,
	                  static_cast<float>(width));
}

void DrawListCanvas::filled(const std::vector<glm::dvec2>& convex, Color color)
{
	const auto corners = at(convex);
	list_.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), packedForImGui(color));
}

void DrawListCanvas::filled(const Area& area, Color color)
{
	list_.AddRectFilled(at(area.lo), at(area.hi), packedForImGui(color));
}

void DrawListCanvas::dot(const glm::dvec2& center, double radius, Color color)
{
	list_.AddCircleFilled(at(center), static_cast<float>(radius), packedForImGui(color));
}

void DrawListCanvas::colorBar(const Area& bar, const ColorMap& colors)
{
	const auto y = [&](int step) { return bar.hi.y - bar.size().y * step / (kColorMapSize - 1); };
	for (int i = 0; i + 1 < kColorMapSize; ++i)
	{
		const ImU32 top = packedForImGui(colors.colors[i + 1]);
		const ImU32 bottom = packedForImGui(colors.colors[i]);
		list_.AddRectFilledMultiColor(at({bar.lo.x, y(i + 1)}), at({bar.hi.x, y(i)}), top, top, bottom, bottom);
	}
}

} // namespace vp::render
