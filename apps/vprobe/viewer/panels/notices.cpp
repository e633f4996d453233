#include "viewer/panels/widgets.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

namespace
{

constexpr double kWidest = 460.0;
constexpr double kMin = 120.0;  // smallest width
constexpr std::size_t kMax = 4; // notices at once, the newest ones

// Returns the height of the notice.
float showNotice(Desk& desk, const Notice& notice, const ImVec2& lower_left, float width)
{
	const Theme& colors = theme(desk.document.settings.dark);
	ImGui::SetNextWindowPos(lower_left, ImGuiCond_Always, {0.0f, 1.0f});
	ImGui::PushStyleColor(ImGuiCol_WindowBg, notice.is_error ? colors.error : colors.note);
	ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().FrameRounding);
	ImGui::Begin(fmt::format("##{}", notice.words).c_str(), nullptr,
	             ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
	                 ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
	const float button = ImGui::GetFrameHeight();
	const ImGuiStyle& style = ImGui::GetStyle();
	const float room = width - button - style.ItemSpacing.x - 2.0f * style.WindowPadding.x;
	ImGui::BeginGroup();
	ImGui::AlignTextToFramePadding();
	ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room);
	ImGui::TextUnformatted(notice.words.c_str());
	ImGui::PopTextWrapPos();
	ImGui::EndGroup();
	ImGui::SameLine();
	if (ImGui::Button("\u00d7", {button, button}))
		desk.document.dismiss(notice.words);
	tip("Takes this away");
	const float height = ImGui::GetWindowHeight();
	ImGui::End();
	ImGui::PopStyleVar();
	ImGui::PopStyleColor();
	return height;
}

} // namespace

void showNotices(Desk& desk, const ScenePart& part)
{
	const std::vector<Notice> notices = desk.document.notices(); // a copy: one may be dismissed meanwhile
	const auto margin = static_cast<float>(10.0 * desk.scale);
	const auto width = static_cast<float>(std::clamp(part.size.x - 20.0 * desk.scale, kMin, kWidest * desk.scale));
	ImVec2 at{static_cast<float>(part.lo.x) + margin, static_cast<float>(part.lo.y + part.size.y) - margin};
	for (std::size_t i = notices.size(); i > 0 && notices.size() - i < kMax; --i)
		at.y -= showNotice(desk, notices[i - 1], at, width) + 0.6f * margin;
}

} // namespace vp::app
