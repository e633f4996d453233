#include "viewer/panels/opacity_graph.h"

#include "viewer/panels/widgets.h"

#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace vp::app
{

namespace
{

constexpr float kGraphHeight = 96.0f;
constexpr float kStripHeight = 16.0f;
constexpr float kPointRadius = 4.5f;
constexpr float kReach = 9.0f;     // from where the mouse takes a point
constexpr int kStripSteps = 128;   // the strip has so many parts
constexpr double kFinest = 1000.0; // steps of a place and of an opacity that the mouse sets

// The part of the window where places and opacities are from 0 to 1.
struct GraphArea
{
	ImVec2 lo;
	ImVec2 hi;

	ImVec2 at(const render::OpacityPoint& point) const
	{
		return {lo.x + (hi.x - lo.x) * static_cast<float>(point.place),
		        hi.y - (hi.y - lo.y) * static_cast<float>(point.opacity)};
	}
	render::OpacityPoint under(const ImVec2& mouse) const
	{
		const auto part = [](float at, float from, float to)
		{ return std::round(kFinest * std::clamp(double(at - from) / (to - from), 0.0, 1.0)) / kFinest; };
		return {part(mouse.x, lo.x, hi.x), part(mouse.y, hi.y, lo.y)};
	}
};

std::optional<std::size_t> graphPointAt(const GraphArea& area, const render::OpacityPoints& points, const ImVec2& mouse,
                                        float reach)
{
	std::optional<std::size_t> nearest;
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		const ImVec2 at = area.at(points[i]);
		if (const float distance = std::hypot(mouse.x - at.x, mouse.y - at.y); distance <= reach)
		{
			nearest = i;
			reach = distance;
		}
	}
	return nearest;
}

// Lets what lies behind translucent colors be seen: light and dark squares.
void drawSquares(ImDrawList& list, const ImVec2& lo, const ImVec2& hi, float side)
{
	list.AddRectFilled(lo, hi, IM_COL32(250, 250, 250, 255));
	int row = 0;
	for (float y = lo.y; y < hi.y; y += side, ++row)
		for (float x = lo.x + (row % 2 == 0 ? 0.0f : side); x < hi.x; x += 2.0f * side)
			list.AddRectFilled({x, y}, {std::min(x + side, hi.x), std::min(y + side, hi.y)},
			                   IM_COL32(150, 150, 150, 255));
}

void drawStrip(ImDrawList& list, const render::ColorMap& map, const ImVec2& lo, const ImVec2& hi, float square)
{
	drawSquares(list, lo, hi, square);
	const auto ink = [&](int step)
	{
		const render::Color color = map.at(double(step) / kStripSteps);
		return IM_COL32(color.r, color.g, color.b, color.a);
	};
	const auto x = [&](int step)
	{ return lo.x + (hi.x - lo.x) * static_cast<float>(step) / static_cast<float>(kStripSteps); };
	for (int i = 0; i < kStripSteps; ++i)
		list.AddRectFilledMultiColor({x(i), lo.y}, {x(i + 1), hi.y}, ink(i), ink(i + 1), ink(i + 1), ink(i));
	list.AddRect(lo, hi, ImGui::GetColorU32(ImGuiCol_Border));
}

void drawBars(ImDrawList& list, const GraphArea& area, std::span<const float> bars)
{
	const float width = (area.hi.x - area.lo.x) / static_cast<float>(std::max<std::size_t>(1, bars.size()));
	for (std::size_t i = 0; i < bars.size(); ++i)
	{
		const float x = area.lo.x + width * static_cast<float>(i);
		list.AddRectFilled({x, area.hi.y - bars[i] * (area.hi.y - area.lo.y)}, {x + width, area.hi.y},
		                   ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.35f));
	}
}

void drawCurve(ImDrawList& list, const Desk& desk, const GraphArea& area, const OpacityGraph& graph)
{
	const auto scale = static_cast<float>(desk.scale);
	const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
	const render::OpacityPoints& points = graph.points;
	list.AddLine(area.at({0.0, points.front().opacity}), area.at(points.front()), ink, 1.5f * scale);
	for (std::size_t i = 1; i < points.size(); ++i)
		list.AddLine(area.at(points[i - 1]), area.at(points[i]), ink, 1.5f * scale);
	list.AddLine(area.at(points.back()), area.at({1.0, points.back().opacity}), ink, 1.5f * scale);
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		const ImU32 fill =
		    i == graph.chosen ? theme(desk.document.settings.dark).held : ImGui::GetColorU32(ImGuiCol_FrameBg);
		list.AddCircleFilled(area.at(points[i]), kPointRadius * scale, fill);
		list.AddCircle(area.at(points[i]), kPointRadius * scale, ink, 0, 1.5f * scale);
	}
}

GraphChange hearMouse(const GraphArea& area, OpacityGraph& graph, float reach)
{
	const ImVec2 mouse = ImGui::GetIO().MousePos;
	const auto hit = graphPointAt(area, graph.points, mouse, reach);
	if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && hit && graph.points.size() > 2)
	{
		graph.chosen = removePoint(graph.points, *hit);
		return GraphChange::edited;
	}
	if (ImGui::IsItemActivated())
	{
		const std::size_t before = graph.points.size();
		graph.chosen = hit ? *hit : addPoint(graph.points, area.under(mouse));
		return graph.points.size() > before ? GraphChange::edited : GraphChange::chosen;
	}
	if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
	{
		movePoint(graph.points, graph.chosen, area.under(mouse));
		return GraphChange::edited;
	}
	return ImGui::IsItemDeactivated() ? GraphChange::released : GraphChange::none;
}

} // namespace

GraphChange showOpacityGraph(const Desk& desk, OpacityGraph& graph)
{
	const auto scale = static_cast<float>(desk.scale);
	const ImVec2 corner = ImGui::GetCursorScreenPos();
	const ImVec2 size{std::max(1.0f, ImGui::GetContentRegionAvail().x), kGraphHeight * scale};
	ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true); // the controls below it do the same by keys
	ImGui::InvisibleButton("##graph", size);
	ImGui::PopItemFlag();
	const float margin = (kPointRadius + 2.0f) * scale; // points at the ends are seen whole
	const GraphArea area{{corner.x + margin, corner.y + margin},
	                     {corner.x + size.x - margin, corner.y + size.y - margin}};
	const GraphChange change = hearMouse(area, graph, kReach * scale);
	tip("How opaque each value is. Click to add a point, drag to move it; the right button removes it. The bars tell "
	    "how "
	    "often values occur on the sheets");
	ImDrawList& list = *ImGui::GetWindowDrawList();
	const ImVec2 end{corner.x + size.x, corner.y + size.y};
	list.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_FrameBg));
	drawBars(list, area, graph.bars);
	list.AddRect(corner, end, ImGui::GetColorU32(ImGuiCol_Border));
	drawCurve(list, desk, area, graph);
	const ImVec2 strip = ImGui::GetCursorScreenPos();
	const float height = std::round(kStripHeight * scale);
	drawStrip(list, graph.map, {area.lo.x, strip.y}, {area.hi.x, strip.y + height}, 0.5f * height);
	ImGui::Dummy({size.x, height});
	return change;
}

} // namespace vp::app
