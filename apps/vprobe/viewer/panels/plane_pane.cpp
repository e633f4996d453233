#include "viewer/panels/pointer_words.h"
#include "viewer/panels/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::app
{

namespace
{

constexpr double kPartOfScene = 0.36; // the pane's width
constexpr double kMinPaneWidth = 180.0;
constexpr double kMaxWidth = 420.0;
constexpr double kAspect = 0.75;
constexpr double kMargin = 10.0;

ImVec2 asImVec(const glm::dvec2& at)
{
	return {static_cast<float>(at.x), static_cast<float>(at.y)};
}

// The wheel pushes the sheet that the pane shows.
void hearWheel(Desk& desk)
{
	const float wheel = ImGui::GetIO().MouseWheel;
	if (wheel == 0.0f || !ImGui::IsWindowHovered())
		return;
	desk.document.perform(wheel > 0.0f ? interact::Action::push_forward : interact::Action::push_back);
}

} // namespace

ScenePart paneOf(const ScenePart& scene, double scale)
{
	const double most = std::clamp(scene.size.x - 2.0 * kMargin * scale, 0.0, kMaxWidth * scale);
	const double width =
	    std::floor(std::clamp(kPartOfScene * scene.size.x, std::min(kMinPaneWidth * scale, most), most));
	const double height = std::floor(std::min(kAspect * width, 0.5 * scene.size.y));
	return {
	    {std::floor(scene.lo.x + kMargin * scale), std::floor(scene.lo.y + scene.size.y - kMargin * scale - height)},
	    {width, height}};
}

// The picture lies below. This draws a frame around it, and keeps the pointer from what is behind the pane.
void showPlanePane(Desk& desk, const ScenePart& part)
{
	const ScenePart pane = paneOf(part, desk.scale);
	const bool open = desk.document.parts.plane_pane && desk.document.shown();
	desk.document.setPane(open ? pixelsOf(pane) : PixelSize{});
	if (!open || !desk.document.shown()->pane || pixelsOf(pane).height == 0)
		return;
	ImGui::SetNextWindowPos(asImVec(pane.lo));
	ImGui::SetNextWindowSize(asImVec(pane.size));
	ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {4.0f, 2.0f});
	ImGui::Begin("pane", nullptr,
	             ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
	                 ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus |
	                 ImGuiWindowFlags_NoFocusOnAppearing);
	ImDrawList& list = *ImGui::GetWindowDrawList();
	list.PushClipRect(asImVec(pane.lo), asImVec(pane.lo + pane.size)); // the padding too
	list.AddRect(asImVec(pane.lo), asImVec(pane.lo + pane.size), ImGui::GetColorU32(ImGuiCol_TextDisabled), 0.0f, 0,
	             static_cast<float>(desk.scale));
	list.PopClipRect();
	const float button = ImGui::GetFrameHeight();
	ImGui::SetCursorPos({static_cast<float>(pane.size.x) - button - 2.0f, 2.0f});
	if (ImGui::Button("\u00d7", {button, button}))
		desk.document.parts.plane_pane = false;
	tip(tipOf(interact::Action::plane_pane));
	hearWheel(desk);
	ImGui::End();
	ImGui::PopStyleVar();
}

} // namespace vp::app
