#include "probe/probe.h"
#include "viewer/panels/widgets.h"

#include <algorithm>

namespace vp::app
{

namespace
{

// Returns true if no visible sheet has a part of its plane within the bounds of the data. Sheets that are empty for
// another reason, such as a hole or a threshold, do not count.
bool isOutside(const probe::Probe& probe, const Box& bounds)
{
	const probe::Probe placed = probe::placed(probe);
	const auto isVisible = [](const probe::Sheet& sheet) { return !sheet.wishes.hidden; };
	const auto isInside = [&](const probe::Sheet& sheet)
	{
		const probe::Sheet content = probe::content(sheet);
		if (!content.plane().meets(bounds))
			return false;
		if (!content.window)
			return true;
		// A window that is beside the data: all corners of the bounds lie beyond one of its sides.
		glm::dvec2 lo(1e300);
		glm::dvec2 hi(-1e300);
		for (int i = 0; i < 8; ++i)
		{
			const Vec3 corner(i & 1 ? bounds.hi.x : bounds.lo.x, i & 2 ? bounds.hi.y : bounds.lo.y,
			                  i & 4 ? bounds.hi.z : bounds.lo.z);
			const Vec3 from = corner - content.origin;
			const glm::dvec2 at(glm::dot(from, content.xAxis()), glm::dot(from, content.up));
			lo = glm::min(lo, at);
			hi = glm::max(hi, at);
		}
		const probe::Window& window = *content.window;
		return window.x0 <= hi.x && window.x1 >= lo.x && window.y0 <= hi.y && window.y1 >= lo.y;
	};
	return std::ranges::any_of(placed.sheets, isVisible) &&
	       std::ranges::none_of(placed.sheets,
	                            [&](const probe::Sheet& sheet) { return isVisible(sheet) && isInside(sheet); });
}

} // namespace

void showWayBack(Desk& desk, const ScenePart& part)
{
	const Document& document = desk.document;
	if (!document.view() || !document.facts() ||
	    !std::holds_alternative<std::monostate>(document.state().probe.surface) ||
	    !isOutside(document.shown()->probe, document.facts()->bounds))
		return;
	ImGui::SetNextWindowPos({static_cast<float>(part.lo.x + 0.5 * part.size.x),
	                         static_cast<float>(part.lo.y + part.size.y - 12.0 * desk.scale)},
	                        ImGuiCond_Always, {0.5f, 1.0f});
	ImGui::PushStyleColor(ImGuiCol_WindowBg, theme(document.settings.dark).note);
	ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().FrameRounding);
	ImGui::Begin("way back", nullptr,
	             ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
	                 ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
	ImGui::AlignTextToFramePadding();
	ImGui::TextUnformatted(document.shown()->probe.sheets.size() > 1 ? "The probe lies outside the data, so it shows "
	                                                                   "nothing."
	                                                                 : "The sheet lies outside the data, so it shows "
	                                                                   "nothing.");
	ImGui::SameLine();
	actionButton(desk, interact::Action::reset_place, "Back to the data (Home)");
	ImGui::End();
	ImGui::PopStyleVar();
	ImGui::PopStyleColor();
}

} // namespace vp::app
