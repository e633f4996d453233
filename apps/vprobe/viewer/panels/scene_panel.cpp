#include "viewer/panels/pointer_words.h"
#include "viewer/panels/sections.h"

namespace vp::app
{

namespace
{

ImVec2 onScreen(const glm::dvec2& pixel, const ScenePart& part)
{
	return {static_cast<float>(part.lo.x + pixel.x), static_cast<float>(part.lo.y + pixel.y)};
}

ImU32 faded(ImU32 color, double alpha)
{
	const auto a = static_cast<ImU32>(alpha * ((color >> IM_COL32_A_SHIFT) & 0xff));
	return (color & ~IM_COL32_A_MASK) | (a << IM_COL32_A_SHIFT);
}

// Returns true if the handle is dragged, or is under the pointer with no part of the user interface between.
bool isHeld(const interact::HandleShape& shape, const PointerController& hand)
{
	return hand.handle() == shape.handle && (hand.isBusy() || !ImGui::GetIO().WantCaptureMouse);
}

ImU32 colorOf(const interact::HandleShape& shape, const PointerController& hand, const Theme& colors)
{
	if (isHeld(shape, hand))
		return colors.held;
	switch (shape.handle.kind)
	{
	case interact::HandleKind::move:
	case interact::HandleKind::turn:
		return faded(colors.handle[shape.handle.axis], shape.alpha);
	default:
		return faded(colors.window_rim, shape.alpha);
	}
}

void drawShape(const interact::HandleShape& shape, const interact::View& view, ImU32 color, float width,
               const ScenePart& part)
{
	ImDrawList& list = *ImGui::GetBackgroundDrawList();
	for (const auto& line : shape.lines)
		for (std::size_t i = 0; i + 1 < line.size(); ++i)
			if (const auto seen = interact::seenSegment(view, line[i], line[i + 1]))
				list.AddLine(onScreen((*seen)[0], part), onScreen((*seen)[1], part), color, width);
}

// Returns the parts of the scene above and beside its pane, so that handles are not drawn over the pane.
std::vector<ScenePart> freeParts(const Desk& desk, const ScenePart& part)
{
	const auto& shown = desk.document.shown();
	if (!desk.document.parts.plane_pane || !shown->pane)
		return {part};
	const ScenePart pane = paneOf(part, desk.scale);
	const glm::dvec2 hi = part.lo + part.size;
	const double right = pane.lo.x + pane.size.x;
	return {{part.lo, {part.size.x, pane.lo.y - part.lo.y}}, {{right, pane.lo.y}, {hi.x - right, hi.y - pane.lo.y}}};
}

// Draws the scene before there is a picture.
void showEmptyScene(Desk& desk, const ScenePart& part)
{
	ImDrawList& list = *ImGui::GetBackgroundDrawList();
	list.AddRectFilled(onScreen({0.0, 0.0}, part), onScreen(part.size, part), ImGui::GetColorU32(ImGuiCol_FrameBg));
	if (!desk.document.loader().isBusy() && !desk.document.facts())
		return showStartPage(desk, part);
	const auto width = static_cast<float>(std::min(360.0 * desk.scale, 0.9 * part.size.x));
	ImGui::SetNextWindowPos(onScreen(0.5 * part.size, part), ImGuiCond_Always, {0.5f, 0.5f});
	ImGui::SetNextWindowSize({width, 0.0f});
	ImGui::Begin("empty", nullptr,
	             ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
	                 ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus);
	showLoading(desk);
	ImGui::End();
}

// Shows what lies under a pointer that rests.
void showPointed(const Desk& desk)
{
	if (!pointerRests() || desk.hand.handle())
		return;
	const auto pointed = pointedAt(desk);
	if (!pointed || !pointed->found)
		return;
	ImGui::BeginTooltip();
	if (const std::string value = valueWords(desk, *pointed); !value.empty())
		ImGui::TextUnformatted(value.c_str());
	ImGui::TextDisabled("%s", cellWords(*pointed).c_str());
	ImGui::EndTooltip();
}

} // namespace

void showScene(Desk& desk, const ScenePart& part)
{
	const auto view = desk.document.view();
	if (!view)
		return showEmptyScene(desk, part);
	const Theme& colors =
	    theme(desk.document.state().look.background.dark()); // has to be visible on the picture, not on the panels
	ImDrawList& list = *ImGui::GetBackgroundDrawList();
	const std::vector<interact::HandleShape> shapes = desk.hand.shapes();
	for (const ScenePart& free : freeParts(desk, part))
	{
		list.PushClipRect(onScreen({0.0, 0.0}, free), onScreen(free.size, free));
		for (const interact::HandleShape& shape : shapes)
			drawShape(shape, *view, colorOf(shape, desk.hand, colors),
			          static_cast<float>(desk.scale * (isHeld(shape, desk.hand) ? 3.0 : 2.0)), part);
		list.PopClipRect();
	}
	showPointed(desk);
	followPointer(desk);
}

} // namespace vp::app
