#include "viewer/panels/color_maps.h"
#include "viewer/panels/opacity_graph.h"
#include "viewer/panels/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vp::app
{

namespace
{

constexpr std::size_t kBars = 64;
constexpr const char* kStep = "Opacity by value"; // the name of its steps in the history

// The values between the ends of the color map.
struct ValueAxis
{
	double lo = 0.0;
	double hi = 1.0;
	bool logarithmic = false;

	double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
	double place(double value) const { return (scaled(value) - scaled(lo)) / (scaled(hi) - scaled(lo)); }
	double value(double place) const
	{
		const double at = scaled(lo) + place * (scaled(hi) - scaled(lo));
		return logarithmic ? std::pow(10.0, at) : at;
	}
	bool operator==(const ValueAxis&) const = default;
};

// Returns the ends of the color map; 0 and 1 before there is a picture, and if all values are the same.
ValueAxis valueAxis(const Document& document)
{
	const view::LookSpec& look = document.state().look;
	const auto& shown = document.shown();
	ValueAxis axis;
	if (look.range)
		axis = {look.range->first, look.range->second, look.logarithmic};
	else if (shown && shown->values)
		axis = {look.logarithmic ? shown->values->log_lo : shown->values->lo, shown->values->hi, look.logarithmic};
	const bool spans = axis.lo < axis.hi && (!axis.logarithmic || axis.lo > 0.0);
	return spans ? axis : ValueAxis{};
}

// Returns how often the sheets show values. While the probe moves, the bars of where it was stay.
std::span<const float> barsOf(const Document& document, const ValueAxis& axis)
{
	static std::array<float, kBars> bars{};
	static std::shared_ptr<const SheetLookups> counted;
	static ValueAxis counted_axis;
	const auto& lookups = document.shown() ? document.shown()->lookups : nullptr;
	if (!document.shown())
		bars = {};
	if (!lookups || (lookups == counted && axis == counted_axis))
		return bars;
	counted = lookups;
	counted_axis = axis;
	std::array<std::size_t, kBars> counts{};
	lookups->count([&](double value) { return axis.place(value); }, counts);
	const auto most = static_cast<float>(std::max<std::size_t>(1, *std::ranges::max_element(counts)));
	// A root lets rare values be seen beside a background that fills most of a scan.
	std::ranges::transform(counts, bars.begin(),
	                       [&](std::size_t count) { return std::sqrt(static_cast<float>(count) / most); });
	return bars;
}

void changePoints(Desk& desk, const render::OpacityPoints& points, const std::string& merge = {})
{
	desk.document.change(
	    kStep, [&](view::ViewSpec& state) { state.look.opacity_points = render::opacityNumbers(points); }, merge);
}

void showAxisEnds(const ValueAxis& axis)
{
	const std::string hi = fmt::format("{:.4g}", axis.hi);
	const float end = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(hi.c_str()).x;
	ImGui::TextDisabled("%.4g", axis.lo);
	ImGui::SameLine(end);
	ImGui::TextDisabled("%s", hi.c_str());
}

void choosePoint(Desk& desk, std::size_t count)
{
	int number = static_cast<int>(desk.document.parts.opacity_point) + 1;
	const int last = static_cast<int>(count);
	labeled("Point");
	if (ImGui::SliderInt("##point", &number, 1, last, fmt::format("%d of {}", last).c_str(),
	                     ImGuiSliderFlags_AlwaysClamp))
		desk.document.parts.opacity_point = static_cast<std::size_t>(number) - 1;
	tip("The point that the controls below change, from the low values to the high ones");
}

// Returns true while the user changes the value.
bool slidePoint(Desk& desk, const Slide& slide, double& value, const char* words)
{
	auto shown = static_cast<float>(value);
	labeled(slide.label);
	const bool changed =
	    ImGui::SliderFloat(fmt::format("##{}", slide.label).c_str(), &shown, static_cast<float>(slide.least),
	                       static_cast<float>(slide.most), slide.format,
	                       ImGuiSliderFlags_AlwaysClamp | (slide.logarithmic ? ImGuiSliderFlags_Logarithmic : 0));
	if (changed)
		value = shown;
	else if (ImGui::IsItemDeactivated())
		desk.document.endMerge();
	tip(words);
	return changed;
}

// Shows the place of the chosen point as a value, between those of its neighbors, and its opacity.
void placePoint(Desk& desk, render::OpacityPoints points, const ValueAxis& axis)
{
	const std::size_t chosen = desk.document.parts.opacity_point;
	const auto valueOf = [&](std::size_t point) { return axis.value(points[point].place); };
	const Slide values{.label = "Value",
	                   .least = chosen > 0 ? valueOf(chosen - 1) : axis.lo,
	                   .most = chosen + 1 < points.size() ? valueOf(chosen + 1) : axis.hi,
	                   .format = "%.4g",
	                   .logarithmic = axis.logarithmic};
	double value = valueOf(chosen);
	double opacity = points[chosen].opacity;
	const bool moved = slidePoint(desk, values, value, "The value that has this opacity");
	const bool faded = slidePoint(desk, {.label = "Opacity"}, opacity, "0 is clear, 1 hides what is behind");
	if (!moved && !faded)
		return;
	// Short numbers: a slider has the digits of a float.
	const double place = moved ? std::round(1e6 * axis.place(value)) / 1e6 : points[chosen].place;
	movePoint(points, chosen, {place, std::round(1e3 * opacity) / 1e3});
	changePoints(desk, points, "opacity point");
}

void showSetBack(Desk& desk, float width)
{
	ImGui::BeginDisabled(desk.document.state().look.opacity_points.empty());
	if (ImGui::Button("Set back", {width, 0.0f}))
		changePoints(desk, {});
	ImGui::EndDisabled();
	tip("Take the opacities of the color map again");
}

void showPointButtons(Desk& desk, render::OpacityPoints points)
{
	std::size_t& chosen = desk.document.parts.opacity_point;
	const float width = shareOfLine(2);
	const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
	ImGui::BeginDisabled(points.size() >= render::kMaxOpacityPoints);
	if (ImGui::Button("Add", {width, 0.0f}))
	{
		chosen = addBeside(points, chosen);
		changePoints(desk, points);
	}
	ImGui::EndDisabled();
	tip("Add a point between this one and the next");
	ImGui::SameLine(0.0f, gap);
	ImGui::BeginDisabled(points.size() <= 2);
	if (ImGui::Button("Remove", {width, 0.0f}))
	{
		chosen = removePoint(points, chosen);
		changePoints(desk, points);
	}
	ImGui::EndDisabled();
	tip("Remove this point; two remain");
	showSetBack(desk, width);
	ImGui::SameLine(0.0f, gap);
	actionButton(desk, interact::Action::save_color_map, "Save\u2026", width);
}

} // namespace

void showColorMapSection(Desk& desk)
{
	showColorMapChoice(desk);
	const render::ColorMap* map = colorMapOf(desk.document.colorMapName());
	if (!map || !map->categories.empty())
	{
		ImGui::TextWrapped("Labels and categories have no opacity by value.");
		return showSetBack(desk, shareOfLine(2)); // points that were set before do not suit them
	}
	std::size_t& chosen = desk.document.parts.opacity_point;
	render::OpacityPoints points = render::opacityPoints(desk.document.state().look.opacity_points);
	if (points.empty())
		points = opacityPointsOf(*map);
	chosen = std::min(chosen, points.size() - 1);
	const ValueAxis axis = valueAxis(desk.document);
	const render::ColorMap edited = withOpacity(*map, points);
	OpacityGraph graph{edited, points, chosen, barsOf(desk.document, axis)};
	const GraphChange change = showOpacityGraph(desk, graph);
	chosen = graph.chosen;
	showAxisEnds(axis);
	if (change == GraphChange::edited)
		changePoints(desk, graph.points, ImGui::IsMouseDown(ImGuiMouseButton_Left) ? "opacity graph" : "");
	else if (change == GraphChange::released)
		desk.document.endMerge();
	choosePoint(desk, graph.points.size());
	placePoint(desk, graph.points, axis);
	showPointButtons(desk, graph.points);
}

} // namespace vp::app
