#include "profile/profile_log.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

namespace vp::app
{

namespace
{

using Section = Timeline::Section;

std::vector<Section> inOrder(std::vector<Section> sections)
{
	std::ranges::stable_sort(sections, [](const Section& a, const Section& b)
	                         { return a.start_ms != b.start_ms ? a.start_ms < b.start_ms : a.depth < b.depth; });
	return sections;
}

std::vector<Section> named(const std::vector<Section>& sections, const char* name, Timeline::Track track)
{
	std::vector<Section> found;
	std::ranges::copy_if(sections, std::back_inserter(found),
	                     [&](const Section& section) { return section.track == track && section.name == name; });
	return found;
}

const char* finderOf(const cut::SheetCut& sheet, std::size_t block)
{
	if (sheet.surface)
		return "subscripts";
	if (sheet.cuts[block].hasSpans())
		return "spans";
	return sheet.cuts[block].steps() == 0 ? "flood" : "traversal";
}

} // namespace

std::vector<StageTime> stageTimes(std::vector<Section> sections)
{
	std::vector<StageTime> times;
	for (const Section& section : inOrder(std::move(sections)))
	{
		if (section.track != Timeline::Track::cpu && section.track != Timeline::Track::gpu)
			continue; // it is only for traces
		const auto same = [&](const StageTime& time)
		{ return time.track == section.track && time.name == section.name; };
		if (const auto known = std::ranges::find_if(times, same); known != times.end())
			known->ms += section.duration_ms;
		else
			times.push_back({section.name, section.track, section.depth, section.duration_ms});
	}
	return times;
}

void ProfileLog::add(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
                     const std::vector<Section>& sections)
{
	const std::vector<Section> ordered = inOrder(sections);
	addStages(ordered);
	addGenerations(ordered);
	addFigures(slice, sheets);
}

void ProfileLog::addFigures(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets)
{
	std::size_t cut = 0, touched = 0, polygons = 0, vertices = 0;
	for (std::size_t s = 0; s < slice.sheets.size(); ++s)
	{
		const cut::SheetCut& sheet = slice.sheets[s];
		for (std::size_t b = 0; b < sheet.cuts.size(); ++b)
		{
			const std::size_t block_touched = sheet.cuts[b].touchedCells();
			cut += sheet.cuts[b].cutCells();
			touched += block_touched;
			if (block_touched > 0)
				finders_.insert(finderOf(sheet, b));
		}
		polygons += sheets[s].mesh.polygons();
		vertices += sheets[s].mesh.positions.size() - sheets[s].borders.vertices_elsewhere;
	}
	cut_cells_.push_back(static_cast<double>(cut));
	touched_cells_.push_back(static_cast<double>(touched));
	polygons_.push_back(static_cast<double>(polygons));
	vertices_.push_back(static_cast<double>(vertices));
}

Stage& ProfileLog::stageOf(const std::string& name, Timeline::Track track, std::uint32_t depth)
{
	const auto same = [&](const Stage& stage) { return stage.track == track && stage.name == name; };
	if (const auto known = std::ranges::find_if(stages_, same); known != stages_.end())
		return *known;
	return stages_.emplace_back(Stage{name, track, depth, std::vector<double>(planes(), 0.0)});
}

void ProfileLog::addStages(const std::vector<Section>& sections)
{
	for (const StageTime& time : stageTimes(sections))
	{
		Stage& stage = stageOf(time.name, time.track, time.depth);
		stage.ms.resize(planes() + 1, 0.0);
		stage.ms.back() = time.ms;
	}
	for (Stage& stage : stages_)
		stage.ms.resize(planes() + 1, 0.0);
}

void ProfileLog::addGenerations(const std::vector<Section>& sections)
{
	const auto classified = named(sections, "classify", Timeline::Track::cpu);
	const auto expanded = named(sections, "expand", Timeline::Track::cpu);
	const auto on_gpu = named(sections, "classify", Timeline::Track::gpu);
	generation_counts_.push_back(static_cast<double>(classified.size()));
	if (generations_.size() < classified.size())
		generations_.resize(classified.size());
	for (std::size_t g = 0; g < classified.size(); ++g)
	{
		GenerationLog& log = generations_[g];
		log.cells.push_back(static_cast<double>(classified[g].cells));
		log.classify_ms.push_back(classified[g].duration_ms);
		if (g < expanded.size()) // after an error there is no expansion
			log.expand_ms.push_back(expanded[g].duration_ms);
		// A generation that lies only in blocks that the CPU classifies has no time on the device.
		if (on_gpu.size() == classified.size())
			log.gpu_ms.push_back(on_gpu[g].duration_ms);
	}
}

void ProfileLog::put(ranks::MessageWriter& to) const
{
	to.put(stages_.size());
	for (const Stage& stage : stages_)
	{
		to.put(stage.name);
		to.put(stage.track);
		to.put(stage.depth);
		to.putAll(stage.ms);
	}
	for (const auto* counts : {&generation_counts_, &cut_cells_, &touched_cells_, &polygons_, &vertices_})
		to.putAll(*counts);
	to.put(finders_.size());
	for (const std::string& finder : finders_)
		to.put(finder);
}

void ProfileLog::include(ranks::MessageReader& other)
{
	const auto combine = [&](std::vector<double>& own, const auto& with)
	{
		const auto others = other.getAll<double>();
		std::ranges::transform(own, others, own.begin(), with);
	};
	const auto slower = [](double a, double b) { return std::max(a, b); };
	for (auto left = other.get<std::size_t>(); left > 0; --left)
	{
		const std::string name = other.getText();
		const auto track = other.get<Timeline::Track>();
		combine(stageOf(name, track, other.get<std::uint32_t>()).ms, slower);
	}
	combine(generation_counts_, slower);
	for (auto* counts : {&cut_cells_, &touched_cells_, &polygons_, &vertices_})
		combine(*counts, std::plus());
	for (auto left = other.get<std::size_t>(); left > 0; --left)
		finders_.insert(other.getText());
}

std::vector<double> ProfileLog::msOf(const std::string& name) const
{
	for (const Stage& stage : stages_)
		if (stage.track == Timeline::Track::cpu && stage.name == name)
			return stage.ms;
	return std::vector<double>(planes(), 0.0);
}

std::vector<double> ProfileLog::gpuMs() const
{
	std::vector<double> sum(planes(), 0.0);
	for (const Stage& stage : stages_)
		if (stage.track == Timeline::Track::gpu)
			std::ranges::transform(sum, stage.ms, sum.begin(), std::plus());
	return sum;
}

std::size_t ProfileLog::emptyPlanes() const
{
	return static_cast<std::size_t>(std::ranges::count(polygons_, 0.0));
}

std::string ProfileLog::finder() const
{
	return finders_.empty() ? "none" : fmt::format("{}", fmt::join(finders_, ", "));
}

} // namespace vp::app
