#include "viewer/panels/cut_figures.h"
#include "viewer/panels/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vp::app
{

namespace
{

constexpr double kWidth = 320.0;
constexpr double kGraph = 34.0; // height
constexpr double kMinTop = 8.0; // ms: shorter times do not fill a graph

struct Row
{
	const char* name;
	const char* words;
	const Figure& (Meter::*figure)() const;
};

constexpr std::array kRows{
    Row{"Frame", "From one frame of the window to the next, while something moves", &Meter::frames},
    Row{"Cut", "Finding and cutting the cells of the sheets that moved", &Meter::cuts},
    Row{"Draw", "Drawing the picture of the sheets", &Meter::draws},
    Row{"Answer", "From a move of the hand to the picture that answers it", &Meter::answers},
};

// Draws the last values as bars, scaled to the highest value.
void drawGraph(const Figure& figure, ImU32 color, float height)
{
	const std::vector<float> history = figure.history();
	const ImVec2 lo = ImGui::GetCursorScreenPos();
	const float width = ImGui::GetContentRegionAvail().x;
	ImDrawList& list = *ImGui::GetWindowDrawList();
	list.AddRectFilled(lo, {lo.x + width, lo.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
	double top = kMinTop;
	for (const float value : history)
		top = std::max(top, static_cast<double>(value));
	const float step = width / static_cast<float>(Figure::kKept);
	const float start = lo.x + step * static_cast<float>(Figure::kKept - history.size());
	for (std::size_t i = 0; i < history.size(); ++i)
	{
		const float x = start + step * static_cast<float>(i);
		const auto bar = static_cast<float>(history[i] / top) * height;
		list.AddRectFilled({x, lo.y + height - bar}, {x + std::max(1.0f, step), lo.y + height}, color);
	}
	const std::string most = fmt::format("{:.0f} ms", top);
	list.AddText({lo.x + width - ImGui::CalcTextSize(most.c_str()).x - 3.0f, lo.y},
	             ImGui::GetColorU32(ImGuiCol_TextDisabled), most.c_str());
	ImGui::Dummy({width, height});
}

void showRow(const Desk& desk, const Row& row, ImU32 color)
{
	const Figure& figure = (desk.meter.*row.figure)();
	ImGui::TextUnformatted(row.name);
	tip(row.words);
	const std::string numbers = fmt::format("{:.1f} ms   median {:.1f}   95 % {:.1f}", figure.last(),
	                                        figure.percentile(0.5), figure.percentile(0.95));
	ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(numbers.c_str()).x);
	ImGui::TextDisabled("%s", numbers.c_str());
	drawGraph(figure, color, static_cast<float>(kGraph * desk.scale));
	tip(row.words);
}

void cutFact(const char* name, const std::string& value, const char* words)
{
	ImGui::TableNextColumn();
	ImGui::TextDisabled("%s", name);
	tip(words);
	ImGui::TableNextColumn();
	ImGui::TextUnformatted(value.c_str());
}

void showCut(const Desk& desk, const PresentedFrame& shown)
{
	const CutFigures cut = figuresOf(*shown.cut);
	const bool floods = cut.generations == 0;
	cutFact("Cut cells", grouped(cut.cut_cells), "Of all sheets");
	cutFact("Touched", grouped(cut.touched), "Cells queued or given a polygon");
	cutFact("Polygons", grouped(cut.polygons), "Drawn");
	cutFact("Cuts / s", fmt::format("{:.1f}", desk.meter.cutsPerSecond()), "While the hand moved");
	cutFact("Generations", floods ? "all at once" : grouped(cut.generations),
	        "Steps of the breadth-first traversal; a flood on the processor has none");
	cutFact("Widest", floods ? "-" : grouped(cut.front_max), "Cells of the largest generation");
}

void showMemory(const Desk& desk, const PresentedFrame& shown)
{
	const grid::Memory& memory = desk.document.facts()->memory;
	cutFact("Grid", bytes(static_cast<double>(memory.read())), "Coordinates, cells and arrays");
	cutFact("Built", bytes(static_cast<double>(memory.built())), "Neighbors, boundary, trees");
	cutFact("Marks", bytes(static_cast<double>(shown.memory.marks)), "Kept from slice to slice");
	cutFact("Device", bytes(static_cast<double>(shown.memory.device)), "Blocks, values and polygons in device memory");
}

void stageRow(const std::string& name, const std::array<std::string, 2>& columns)
{
	ImGui::TableNextColumn();
	ImGui::TextUnformatted(name.c_str());
	for (const std::string& column : columns)
	{
		ImGui::TableNextColumn();
		const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(column.c_str()).x;
		ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, room));
		ImGui::TextDisabled("%s", column.c_str());
	}
}

void stageRow(std::uint32_t depth, const std::string& name, double median, double last)
{
	stageRow(std::string(2 * depth, ' ') + name, {fmt::format("{:.2f}", median), fmt::format("{:.2f}", last)});
}

// The stages of `vprobe profile`, under the same names.
void showStages(const Desk& desk)
{
	const std::vector<StageFigure> stages = desk.document.times().stages();
	if (stages.empty() || !ImGui::TreeNodeEx("Stages", ImGuiTreeNodeFlags_DefaultOpen))
		return;
	tip("Milliseconds a picture with one sample: the median of the last 60, and the last one");
	if (ImGui::BeginTable("stages", 3))
	{
		stageRow("ms a picture", {"median", "last"});
		const auto showTrack = [&](Timeline::Track track, std::uint32_t depth)
		{
			for (const StageFigure& stage : stages)
				if (stage.track == track)
					stageRow(stage.depth + depth, stage.name, stage.median, stage.last);
		};
		showTrack(Timeline::Track::cpu, 0);
		double median = 0.0, last = 0.0;
		for (const StageFigure& stage : stages)
			if (stage.track == Timeline::Track::gpu)
			{
				median += stage.median;
				last += stage.last;
			}
		if (last > 0.0)
			stageRow(0, "gpu", median, last);
		showTrack(Timeline::Track::gpu, 1);
		ImGui::EndTable();
	}
	ImGui::TreePop();
}

void showCutFacts(const Desk& desk)
{
	const auto& shown = desk.document.shown();
	if (!shown || !desk.document.facts() || !ImGui::BeginTable("facts", 4))
		return;
	showCut(desk, *shown);
	showMemory(desk, *shown);
	ImGui::EndTable();
}

} // namespace

void showProfile(Desk& desk, const ScenePart& part)
{
	const auto margin = static_cast<float>(10.0 * desk.scale);
	const auto width = static_cast<float>(std::min(kWidth * desk.scale, part.size.x - 20.0 * desk.scale));
	ImGui::SetNextWindowPos({static_cast<float>(part.lo.x) + margin, static_cast<float>(part.lo.y) + margin});
	ImGui::SetNextWindowSize({width, 0.0f});
	const float room = std::max(1.0f, static_cast<float>(part.size.y) - 2.0f * margin); // past it, the overlay scrolls
	ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, room});
	ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().FrameRounding);
	ImGui::Begin("profile", nullptr,
	             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
	                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
	const Theme& colors = theme(desk.document.settings.dark);
	for (std::size_t i = 0; i < kRows.size(); ++i)
		showRow(desk, kRows[i], colors.graph[i]);
	showStages(desk);
	showCutFacts(desk);
	ImGui::BeginDisabled(!desk.document.shown());
	if (ImGui::Button("Write a trace\u2026"))
		desk.document.question = Question::save_trace;
	ImGui::EndDisabled();
	tip("Where the time of the last minute went, on the processor and on the device");
	ImGui::End();
	ImGui::PopStyleVar();
}

} // namespace vp::app
