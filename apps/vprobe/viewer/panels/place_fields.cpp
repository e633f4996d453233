#include "base/digits.h"
#include "interact/nudge.h"
#include "interact/placing.h"
#include "interact/steps.h"
#include "viewer/panels/sections.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr double kDirectionSpeed = 0.005;
constexpr double kFirstWindow = 0.5; // part of the data's size, when a window is switched on
constexpr double kMinDirection = 1e-6;

struct Place
{
	interact::Part part;
	probe::Frame frame;
};

void change(Desk& desk, const Place& place, const char* label, const probe::Frame& frame)
{
	desk.document.setProbe(label, interact::withFrame(desk.document.probe(), place.part, frame), label);
}

void fieldHeading(const char* words)
{
	ImGui::TextDisabled("%s", words);
	ImGui::SetNextItemWidth(-1.0f);
}

void showOrigin(Desk& desk, const Place& place)
{
	fieldHeading("Position");
	probe::Frame frame = place.frame;
	const Vec3& at = frame.origin;
	const double farthest = std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)});
	// ImGui rounds the number to the digits that it shows.
	const std::string format = fmt::format("%.{}g", digitsFor(farthest, 0.1 * lengthSpeed(desk), 5));
	if (dragNumbers(desk, {.id = "##origin", .speed = lengthSpeed(desk), .format = format.c_str()}, &frame.origin.x, 3,
	                "x, y and z of the origin. Drag, or click and type"))
		change(desk, place, "Position", frame);
}

void showNormal(Desk& desk, const Place& place)
{
	fieldHeading("Normal");
	Vec3 normal = place.frame.normal;
	if (dragNumbers(desk, {"##normal", kDirectionSpeed}, &normal.x, 3, "Where the sheet faces; any length") &&
	    glm::length(normal) > kMinDirection)
		change(desk, place, "Normal", interact::normalTo(place.frame, normal));
}

void showUp(Desk& desk, const Place& place)
{
	fieldHeading("Up");
	Vec3 up = place.frame.up;
	if (dragNumbers(desk, {"##up", kDirectionSpeed}, &up.x, 3,
	                "The sheet's y axis; it is made perpendicular to the normal") &&
	    glm::length(glm::cross(up, place.frame.normal)) > kMinDirection)
		change(desk, place, "Up", probe::makeFrame(place.frame.origin, place.frame.normal, up));
}

void showPart(Desk& desk, const probe::Probe& probe, bool& own)
{
	if (probe.sheets.size() < 2)
		return;
	labeled("Place of");
	const std::string sheet = fmt::format("Sheet {} alone", desk.document.sheet() + 1);
	if (ImGui::BeginCombo("##part", own ? sheet.c_str() : "The whole probe"))
	{
		if (ImGui::Selectable("The whole probe", !own))
			own = false;
		if (ImGui::Selectable(sheet.c_str(), own))
			own = true;
		ImGui::EndCombo();
	}
	tip("What the fields below move");
}

void showWindowSize(Desk& desk, const probe::Probe& probe, std::size_t sheet)
{
	const probe::Window& window = *probe.sheets[sheet].window;
	const double size = interact::sizeOf(desk.document.facts()->bounds);
	double sides[2] = {window.width(), window.height()};
	ImGui::SetNextItemWidth(-1.0f);
	if (!dragNumbers(desk,
	                 {"##window", lengthSpeed(desk), interact::kSmallestWindow * size, interact::kLargestWindow * size},
	                 sides, 2, "Width and height of the sheet's window, along its x and y axes"))
		return;
	const double across = 0.5 * (window.x0 + window.x1);
	const double along = 0.5 * (window.y0 + window.y1);
	const probe::Window next{across - 0.5 * sides[0], across + 0.5 * sides[0], along - 0.5 * sides[1],
	                         along + 0.5 * sides[1]};
	desk.document.setProbe("Window", interact::withWindow(probe, sheet, next, false), "Window");
}

void showWindow(Desk& desk, const probe::Probe& probe)
{
	const std::size_t sheet = std::min(desk.document.sheet(), probe.sheets.size() - 1);
	bool has = probe.sheets[sheet].window.has_value();
	if (ImGui::Checkbox("Window", &has))
	{
		probe::Probe next = probe;
		const double side = kFirstWindow * interact::sizeOf(desk.document.facts()->bounds);
		for (probe::Sheet& each : next.sheets)
			each.window = has ? std::optional(probe::centeredWindow(side, side)) : std::nullopt;
		desk.document.setProbe("Window", next);
		return;
	}
	tip("Sheets end at a rectangle, which is cut and drawn alone; else they reach through the whole grid");
	if (has)
		showWindowSize(desk, probe, sheet);
}

void showButtons(Desk& desk)
{
	const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
	ImGui::TextDisabled("Normal to");
	actionButton(desk, Action::normal_x, "x", shareOfLine(5));
	ImGui::SameLine(0.0f, gap);
	actionButton(desk, Action::normal_y, "y", shareOfLine(4));
	ImGui::SameLine(0.0f, gap);
	actionButton(desk, Action::normal_z, "z", shareOfLine(3));
	ImGui::SameLine(0.0f, gap);
	actionButton(desk, Action::normal_to_camera, "eye", shareOfLine(2));
	ImGui::SameLine(0.0f, gap);
	actionButton(desk, Action::snap_normal, "snap", shareOfLine(1));
	actionButton(desk, Action::reset_place, "Reset the place", shareOfLine(2));
	ImGui::SameLine(0.0f, gap);
	actionButton(desk, Action::face_sheet, "Face it", shareOfLine(1));
}

} // namespace

void showPlaceFields(Desk& desk)
{
	static bool own = false;
	const probe::Probe probe = desk.document.probe();
	if (probe.sheets.empty())
		return;
	own = own && probe.sheets.size() > 1;
	showPart(desk, probe, own);
	const interact::Part part =
	    own ? interact::Part(std::min(desk.document.sheet(), probe.sheets.size() - 1)) : std::nullopt;
	const Place place{part, interact::frameOf(probe, part)};
	showOrigin(desk, place);
	showNormal(desk, place);
	showUp(desk, place);
	showWindow(desk, desk.document.probe());
	showButtons(desk);
}

void showMagnifierSection(Desk& desk)
{
	bool& on = desk.document.parts.magnifier;
	ImGui::Checkbox("Wheel and drag magnify", &on);
	tip(tipOf(Action::magnifier));
	const probe::Probe probe = desk.document.probe();
	if (probe.sheets.empty())
		return;
	const std::size_t sheet = std::min(desk.document.sheet(), probe.sheets.size() - 1);
	const double now = probe.sheets[sheet].fx.magnification;
	double next = now;
	labeled("Factor");
	if (dragNumbers(desk,
	                {.id = "##factor",
	                 .speed = 0.01,
	                 .least = interact::kMinMagnification,
	                 .most = interact::kMaxMagnification,
	                 .format = "%.4g\u00d7",
	                 .logarithmic = true},
	                &next, 1, "How many times larger the chosen sheet shows what it cuts"))
		desk.document.setProbe("Magnify", interact::magnified(probe, sheet, next / now, {0.0, 0.0}), "Magnify");
	actionButton(desk, Action::reset_magnifier, "Reset", shareOfLine(1));
}

} // namespace vp::app
