#include "view/pointer_words.h"
#include "view/sections.h"

#include <fmt/format.h>

namespace vp::app
{

namespace
{

ImVec2 onScreen(const glm::dvec2& pixel, const ScenePart& part)
{
	return {static_cast<float>(part.lo.x + pixel.x), static_cast<float>(part.lo.y + pixel.y)};
}

ImU32 faded(ImU32 colour, double alpha)
{
	const auto a = static_cast<ImU32>(alpha * ((colour >> IM_COL32_A_SHIFT) & 0xff));
	return (colour & ~IM_COL32_A_MASK) | (a << IM_COL32_A_SHIFT);
}

ImU32 colourOf(const interact::HandleShape& shape, const Hand& hand, const Theme& colours)
{
	if (hand.handle() == shape.handle)
		return colours.held;
	switch (shape.handle.kind)
	{
	case interact::HandleKind::move:
	case interact::HandleKind::turn:
		return faded(colours.handle[shape.handle.axis], shape.alpha);
	default:
		return faded(colours.window_rim, shape.alpha);
	}
}

void drawShape(const interact::HandleShape& shape, const interact::View& view, ImU32 colour, float width,
               const ScenePart& part)
{
	ImDrawList& list = *ImGui::GetBackgroundDrawList();
	for (const auto& line : shape.lines)
		for (std::size_t i = 0; i + 1 < line.size(); ++i)
			if (const auto seen = interact::seenSegment(view, line[i], line[i + 1]))
				list.AddLine(onScreen((*seen)[0], part), onScreen((*seen)[1], part), colour, width);
}

// Where there is no picture yet.
void showEmptyScene(Desk& desk, const ScenePart& part)
{
	ImDrawList& list = *ImGui::GetBackgroundDrawList();
	list.AddRectFilled(onScreen({0.0, 0.0}, part), onScreen(part.size, part), ImGui::GetColorU32(ImGuiCol_FrameBg));
	const auto width = static_cast<float>(std::min(360.0 * desk.scale, 0.9 * part.size.x));
	ImGui::SetNextWindowPos(onScreen(0.5 * part.size, part), ImGuiCond_Always, {0.5f, 0.5f});
	ImGui::SetNextWindowSize({width, 0.0f});
	ImGui::Begin("empty", nullptr,
	             ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
	                 ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus);
	if (desk.bench.loader().isBusy() || desk.bench.facts())
		showLoading(desk);
	else
	{
		const std::string hint = fmt::format("Drop a file here or {}", interact::keysOf(interact::Action::open));
		ImGui::SetCursorPosX(0.5f * (width - ImGui::CalcTextSize(hint.c_str()).x));
		ImGui::TextUnformatted(hint.c_str());
	}
	ImGui::End();
}

// What lies under a pointer that rests.
void showPointed(const Desk& desk)
{
	if (!pointerRests())
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
	const auto view = desk.bench.view();
	if (!view)
		return showEmptyScene(desk, part);
	const Theme& colours = theme(desk.bench.settings.dark);
	ImDrawList& list = *ImGui::GetBackgroundDrawList();
	list.PushClipRect(onScreen({0.0, 0.0}, part), onScreen(part.size, part));
	for (const interact::HandleShape& shape : desk.hand.shapes())
		drawShape(shape, *view, colourOf(shape, desk.hand, colours),
		          static_cast<float>(desk.scale * (desk.hand.handle() == shape.handle ? 3.0 : 2.0)), part);
	list.PopClipRect();
	showPointed(desk);
}

} // namespace vp::app
