#include "viewer/panels/cut_figures.h"
#include "viewer/panels/pointer_words.h"
#include "viewer/panels/widgets.h"

#include <fmt/format.h>

namespace vp::app
{

namespace
{

std::string costs(const PresentedFrame& shown, const Meter& meter)
{
	return fmt::format("{} cells   cut {:.1f} ms   draw {:.1f} ms", grouped(figuresOf(*shown.cut).cut_cells),
	                   meter.cuts().last(), meter.draws().last());
}

} // namespace

void showStatusLine(Desk& desk, const ScenePart& room)
{
	ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ImGui::GetStyle().WindowPadding.x, 0.0f});
	beginFixed("status", room, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
	ImGui::PopStyleVar();
	ImGui::SetCursorPosY(0.5f * (static_cast<float>(room.size.y) - ImGui::GetTextLineHeight()));
	const auto& shown = desk.document.shown();
	if (!shown)
	{
		ImGui::TextDisabled("%s", desk.document.loader().isBusy() ? "Loading" : "Nothing is loaded");
		ImGui::End();
		return;
	}
	const std::string right =
	    (shown->draft ? fmt::format("level {} while it moves   ", *shown->draft) : "") + costs(*shown, desk.meter);
	const float end = ImGui::GetContentRegionMax().x;
	const float right_at = end - ImGui::CalcTextSize(right.c_str()).x;
	const std::string left = pointerLine(desk);
	ImGui::PushClipRect(
	    {static_cast<float>(room.lo.x), static_cast<float>(room.lo.y)},
	    {static_cast<float>(room.lo.x) + right_at - ImGui::GetFontSize(), static_cast<float>(room.lo.y + room.size.y)},
	    true);
	ImGui::TextUnformatted(left.c_str());
	ImGui::PopClipRect();
	tip(left);
	ImGui::SameLine(right_at);
	ImGui::TextDisabled("%s", right.c_str());
	tip("Cells that the sheets cut; what the last cut and the last picture took");
	ImGui::End();
}

} // namespace vp::app
