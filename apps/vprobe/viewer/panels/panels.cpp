#include "viewer/panels/panels.h"

#include <algorithm>

namespace vp::app
{

namespace
{

constexpr double kSideWidth = 290.0;
constexpr double kLineHeight = 26.0;

ScenePart abovePane(const ScenePart& scene, double scale)
{
	return {scene.lo, {scene.size.x, paneOf(scene, scale).lo.y - scene.lo.y}};
}

} // namespace

ScenePart showPanels(Desk& desk)
{
	showMenu(desk);
	const ImGuiViewport& all = *ImGui::GetMainViewport();
	ScenePart scene{{all.WorkPos.x, all.WorkPos.y}, {all.WorkSize.x, all.WorkSize.y}};
	if (desk.document.parts.panels && scene.size.y > kLineHeight * desk.scale)
	{
		const double line = kLineHeight * desk.scale;
		scene.size.y -= line;
		showStatusLine(desk, {{scene.lo.x, scene.lo.y + scene.size.y}, {scene.size.x, line}});
		const double side = std::min(kSideWidth * desk.scale, 0.4 * scene.size.x);
		scene.size.x -= side;
		showSidePanel(desk, {{scene.lo.x + scene.size.x, scene.lo.y}, {side, scene.size.y}});
	}
	scene.size = glm::max(scene.size, glm::dvec2(0.0)); // a window may be lower than its menu
	showScene(desk, scene);
	showPlanePane(desk, scene);
	showWayBack(desk, scene);
	showNotices(desk, desk.document.parts.plane_pane ? abovePane(scene, desk.scale) : scene);
	if (desk.document.parts.profile)
		showProfile(desk, scene);
	showHints(desk, scene);
	if (desk.document.parts.help)
		showHelp(desk);
	if (desk.document.parts.command_search)
		showCommandSearch(desk);
	showQuestions(desk);
	return scene;
}

} // namespace vp::app
