#include "viewer/panels/theme.h"

#include "render/font/font.h"

#include <cmath>

namespace vp::app
{

namespace
{

constexpr double kFontPixels = 14.0;

ImVec4 gray(float value, float alpha = 1.0f)
{
	return {value, value * 1.01f, value * 1.03f, alpha};
}

void setColors(ImGuiStyle& style, bool dark)
{
	if (dark)
		ImGui::StyleColorsDark(&style);
	else
		ImGui::StyleColorsLight(&style);
	const ImVec4 accent = dark ? ImVec4(0.30f, 0.52f, 0.74f, 1.0f) : ImVec4(0.22f, 0.46f, 0.70f, 1.0f);
	const auto tinted = [&](float alpha) { return ImVec4(accent.x, accent.y, accent.z, alpha); };
	ImVec4* colors = style.Colors;
	colors[ImGuiCol_Text] = dark ? gray(0.90f) : gray(0.12f);
	colors[ImGuiCol_TextDisabled] = dark ? gray(0.56f) : gray(0.45f);
	colors[ImGuiCol_WindowBg] = colors[ImGuiCol_PopupBg] = colors[ImGuiCol_MenuBarBg] =
	    dark ? gray(0.13f) : gray(0.95f);
	colors[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
	colors[ImGuiCol_Border] = dark ? gray(0.30f) : gray(0.78f);
	colors[ImGuiCol_FrameBg] = dark ? gray(0.19f) : gray(0.995f);
	colors[ImGuiCol_FrameBgHovered] = dark ? gray(0.24f) : gray(0.90f);
	colors[ImGuiCol_FrameBgActive] = dark ? gray(0.28f) : gray(0.86f);
	colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = dark ? gray(0.17f) : gray(0.90f);
	colors[ImGuiCol_CheckMark] = colors[ImGuiCol_SliderGrab] = accent;
	colors[ImGuiCol_SliderGrabActive] = tinted(0.8f);
	colors[ImGuiCol_Button] = dark ? gray(0.23f) : gray(0.87f);
	colors[ImGuiCol_ButtonHovered] = tinted(0.55f);
	colors[ImGuiCol_ButtonActive] = tinted(0.85f);
	colors[ImGuiCol_Header] = dark ? gray(0.20f) : gray(0.89f);
	colors[ImGuiCol_HeaderHovered] = tinted(0.45f);
	colors[ImGuiCol_HeaderActive] = tinted(0.65f);
	colors[ImGuiCol_PlotLines] = colors[ImGuiCol_PlotHistogram] = accent;
}

} // namespace

const Theme& theme(bool dark)
{
	static const Theme kDark{{IM_COL32(226, 96, 84, 255), IM_COL32(104, 190, 96, 255), IM_COL32(92, 154, 235, 255)},
	                         IM_COL32(235, 235, 240, 150),
	                         IM_COL32(255, 208, 84, 255),
	                         IM_COL32(44, 58, 74, 240),
	                         IM_COL32(110, 40, 36, 245),
	                         {IM_COL32(92, 154, 235, 255), IM_COL32(226, 160, 84, 255), IM_COL32(104, 190, 96, 255),
	                          IM_COL32(190, 130, 220, 255)}};
	static const Theme kLight{{IM_COL32(196, 58, 48, 255), IM_COL32(48, 138, 52, 255), IM_COL32(38, 98, 190, 255)},
	                          IM_COL32(40, 44, 52, 150),
	                          IM_COL32(222, 138, 0, 255),
	                          IM_COL32(222, 232, 242, 245),
	                          IM_COL32(250, 216, 212, 250),
	                          {IM_COL32(38, 98, 190, 255), IM_COL32(196, 120, 30, 255), IM_COL32(48, 138, 52, 255),
	                           IM_COL32(140, 70, 170, 255)}};
	return dark ? kDark : kLight;
}

void applyTheme(bool dark, double scale)
{
	ImGuiStyle style;
	setColors(style, dark);
	style.WindowRounding = 0.0f;
	style.FrameRounding = style.GrabRounding = style.PopupRounding = 4.0f;
	style.WindowBorderSize = 0.0f;
	style.FrameBorderSize = 1.0f;
	style.WindowPadding = {10.0f, 8.0f};
	style.FramePadding = {7.0f, 3.0f};
	style.ItemSpacing = {7.0f, 5.0f};
	style.ItemInnerSpacing = {6.0f, 4.0f};
	style.ScrollbarSize = 12.0f;
	style.ScaleAllSizes(static_cast<float>(scale));
	ImGui::GetStyle() = style;
}

void makeFonts(double scale)
{
	ImGuiIO& io = ImGui::GetIO();
	io.Fonts->Clear();
	const auto file = render::fontFile();
	ImFontConfig config;
	config.FontDataOwnedByAtlas = false;
	// Letters for units, degrees and powers, arrows, and the symbols of playback.
	static const ImWchar kLetters[] = {0x20,   0x24f,  0x370,  0x3ff,  0x2000, 0x2027, 0x2070, 0x209f, 0x2190, 0x21ff,
	                                   0x2200, 0x22ff, 0x23e9, 0x23fa, 0x25a0, 0x25ff, 0x2700, 0x27bf, 0};
	io.Fonts->AddFontFromMemoryTTF(const_cast<std::byte*>(file.data()), static_cast<int>(file.size()),
	                               static_cast<float>(std::round(kFontPixels * scale)), &config, kLetters);
	io.Fonts->Build();
}

} // namespace vp::app
