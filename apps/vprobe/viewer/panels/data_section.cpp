#include "view/input_title.h"
#include "viewer/panels/sections.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace vp::app
{

namespace
{

using interact::Action;

void gridFact(const char* label, const std::string& value)
{
	labeled(label);
	clippedText(value);
}

void showGridFacts(const DatasetInfo& facts)
{
	clippedText(view::inputTitle(facts.inputs));
	tip(fmt::format("{}", fmt::join(facts.inputs, "\n")));
	gridFact("Grid", facts.blocks > 1 ? fmt::format("{}, {} blocks", facts.kind, facts.blocks) : facts.kind);
	gridFact("Cells", grouped(facts.cells));
	gridFact("Points", grouped(facts.points));
	gridFact("Cut by", facts.classifier == "cpu" ? "the processor" : facts.device);
}

} // namespace

// Nobody knows beforehand how much is still to be read, so the bar shows a part that wanders.
void showLoading(Desk& desk)
{
	const Loader& loader = desk.document.loader();
	clippedText(loader.isBusy() ? fmt::format("Loading {}", loader.what()) : "Drawing the first picture");
	const float width = ImGui::GetContentRegionAvail().x;
	const float height = std::round(static_cast<float>(4.0 * desk.scale));
	const ImVec2 at = ImGui::GetCursorScreenPos();
	const auto place = static_cast<float>(0.5 - 0.5 * std::cos(1.6 * loader.seconds()));
	ImDrawList& list = *ImGui::GetWindowDrawList();
	const auto bar = [&](float from, float to, ImGuiCol color)
	{
		list.AddRectFilled({at.x + from * width, at.y}, {at.x + to * width, at.y + height}, ImGui::GetColorU32(color),
		                   0.5f * height);
	};
	bar(0.0f, 1.0f, ImGuiCol_FrameBg);
	bar(0.7f * place, 0.7f * place + 0.3f, ImGuiCol_CheckMark);
	ImGui::Dummy({width, height});
	if (!loader.isBusy())
		return;
	ImGui::AlignTextToFramePadding();
	ImGui::Text("%.0f s", std::floor(loader.seconds()));
	ImGui::SameLine();
	if (ImGui::Button("Cancel"))
		desk.document.cancelLoading();
	tip(desk.document.facts() ? "Stops loading; what is shown stays" : "Stops loading");
}

void showDataSection(Desk& desk)
{
	if (desk.document.facts())
		showGridFacts(*desk.document.facts());
	if (desk.document.loader().isBusy())
		return showLoading(desk);
	if (!desk.document.facts())
		ImGui::TextDisabled("Nothing is loaded");
	actionButton(desk, Action::open, "Open\u2026", shareOfLine(2));
	if (!desk.document.facts())
		return;
	ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
	if (ImGui::Button("Reload", {shareOfLine(1), 0.0f}))
		desk.document.reload();
	tip("Reads the files again, as after they were written anew");
}

} // namespace vp::app
