#include "view/words.h"
#include "viewer/panels/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace vp::app
{

namespace
{

constexpr int kMaxAlong = 60; // maximum of the slider for points; the option takes more
constexpr double kMaxSteps = 400.0;

constexpr std::array kKinds{Choice{"none", "None"}, Choice{"tufts", "Tufts"}, Choice{"lines", "Lines"},
                            Choice{"ribbons", "Ribbons"}, Choice{"tubes", "Tubes"}};
constexpr std::array kDirections{Choice{"forward", "Forward"}, Choice{"backward", "Backward"}, Choice{"both", "Both"}};
constexpr std::array kParts{Choice{"whole", "Whole"}, Choice{"tangential", "In the sheet"},
                            Choice{"normal", "Through the sheet"}};

template <class T>
void showVectorChoice(Desk& desk, const char* label, std::span<const Choice> choices, T view::VectorSpec::*option,
                      std::string_view words)
{
	showChoice(desk, label, choices, view::text(desk.document.state().probe.vectors.*option), words,
	           [&](view::ViewSpec& state, const char* word) { state.probe.vectors.*option = *view::parse<T>(word); });
}

void addArrays(const DatasetInfo& facts, bool only_vectors, std::vector<Choice>& choices)
{
	for (const DatasetInfo::Array& array : facts.arrays)
		if (!only_vectors || DatasetInfo::isVector(array))
			choices.push_back({array.word.c_str(), array.name.c_str()});
}

void showArray(Desk& desk)
{
	std::vector<Choice> choices;
	addArrays(*desk.document.facts(), true, choices);
	const std::string& array = desk.document.state().probe.vectors.array;
	showChoice(desk, "Array", choices, array.empty() ? choices.front().word : array,
	           "The vectors that move the particles",
	           [](view::ViewSpec& state, const char* word) { state.probe.vectors.array = word; });
}

void showColor(Desk& desk)
{
	std::vector<Choice> choices{{"", "The vector's length"}};
	addArrays(*desk.document.facts(), false, choices);
	for (const Choice& color : {Choice{"black", "Black"}, Choice{"grey", "Grey"}, Choice{"white", "White"}})
		choices.push_back(color);
	showChoice(desk, "Color", choices, desk.document.state().look.vectors.color, "By an array, or one color",
	           [](view::ViewSpec& state, const char* word) { state.look.vectors.color = word; });
}

void showDensity(Desk& desk)
{
	int along = desk.document.state().probe.vectors.lattice;
	labeled("Density");
	if (ImGui::SliderInt("##density", &along, 1, kMaxAlong, "%d along the side"))
		desk.document.change(
		    "Density", [&](view::ViewSpec& state) { state.probe.vectors.lattice = std::max(1, along); }, "density");
	if (ImGui::IsItemDeactivated())
		desk.document.endMerge();
	tip("Points on the longer side of a window, or of the cut");
	showSlider(desk, {.label = "Jitter"}, "vector_jitter");
}

// If the user sets no step, it follows from the lattice and the fastest particle.
void showStep(Desk& desk)
{
	const view::VectorSpec& options = desk.document.state().probe.vectors;
	const double shown = desk.document.shown() ? desk.document.shown()->vector_dt : 0.0;
	double dt = options.dt.value_or(shown);
	if (!(dt > 0.0))
		return;
	labeled("Time step");
	const float button = options.dt ? ImGui::CalcTextSize("Auto").x + 3.0f * ImGui::GetStyle().FramePadding.x : 0.0f;
	ImGui::SetNextItemWidth(-button - 1.0f);
	if (dragNumbers(desk, {.id = "##dt", .speed = 0.01 * dt, .least = 1e-3 * dt, .most = 1e3 * dt, .format = "%.4g"},
	                &dt, 1, "The time of a step: how long tufts are. Drag, or double-click and type"))
		desk.document.change(
		    "Time step", [&](view::ViewSpec& state) { state.probe.vectors.dt = dt; }, "dt");
	if (!options.dt)
		return;
	ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
	if (ImGui::Button("Auto"))
		desk.document.change("Time step", [](view::ViewSpec& state) { state.probe.vectors.dt.reset(); });
	tip("The fastest particle goes as far as the points are apart");
}

} // namespace

void showVectorSection(Desk& desk)
{
	showVectorChoice(desk, "Show", kKinds, &view::VectorSpec::kind,
	                 "Tufts are arrows, one step long; the others follow particles a long way");
	const view::VectorSpec& options = desk.document.state().probe.vectors;
	if (!options.on())
		return;
	showArray(desk);
	showColor(desk);
	showDensity(desk);
	showSlider(desk, {.label = "Steps", .most = kMaxSteps, .logarithmic = true}, options.stepsOrDefault(),
	           "How many steps a particle goes",
	           [](view::ViewSpec& state, double steps) { state.probe.vectors.steps = steps; });
	showStep(desk);
	if (desk.document.facts()->times.size() > 1)
		toggle(desk, "Path lines", "path_lines");
	showVectorChoice(desk, "Direction", kDirections, &view::VectorSpec::direction,
	                 "With the flow, against it, or both");
	showVectorChoice(desk, "Part", kParts, &view::VectorSpec::part, "What of the vector moves the particles");
	showSlider(desk, {.label = "Opacity"}, "vector_opacity");
}

} // namespace vp::app
