#pragma once

#include "base/timeline.h"
#include "ranks/message.h"
#include "report/stats_json.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace vp::app
{

// Holds the time that one part of the work took on each plane of a sweep.
struct Stage
{
	std::string name;
	Timeline::Track track;
	std::uint32_t depth; // number of stages that contain it; 0 for stages on the GPU
	std::vector<double> ms;
};

// The time that one part of the work took on one plane.
struct StageTime
{
	std::string name;
	Timeline::Track track;
	std::uint32_t depth; // as in Stage
	double ms;
};

// Sums the sections of one plane by their names. The stages stand in the order in which they begin.
std::vector<StageTime> stageTimes(std::vector<Timeline::Section> sections);

// Holds the figures of generation k, one entry for each plane whose traversal has this generation.
struct GenerationLog
{
	std::vector<double> cells; // in the front, over all sheets
	std::vector<double> classify_ms;
	std::vector<double> expand_ms;
	std::vector<double> gpu_ms; // empty if the device classified nothing, or has no timers
};

// Collects the figures of a profile, plane by plane. It needs some dozens of numbers per plane.
class ProfileLog
{
public:
	// sections: everything that the work of this plane put on the timeline.
	void add(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
	         const std::vector<Timeline::Section>& sections);

	// A process that puts the logs of several together calls these: the times become those of the slowest process, and
	// the work becomes the sum. Generations stay those of this log.
	void put(ranks::MessageWriter& to) const;
	void include(ranks::MessageReader& other);

	std::size_t planes() const { return cut_cells_.size(); }
	const std::vector<Stage>& stages() const { return stages_; } // in the order in which they begin
	std::vector<double> msOf(const std::string& stage) const;    // per plane, for a stage of the CPU
	std::vector<double> gpuMs() const;                           // per plane, all stages of the GPU together
	const std::vector<GenerationLog>& generations() const { return generations_; }
	const std::vector<double>& generationCounts() const { return generation_counts_; } // per plane

	// Per plane, summed over all sheets. Where curved cells were cut into linear ones, the linear cells count.
	const std::vector<double>& cutCells() const { return cut_cells_; }
	const std::vector<double>& touchedCells() const { return touched_cells_; }
	const std::vector<double>& polygons() const { return polygons_; }
	const std::vector<double>& vertices() const { return vertices_; }
	std::size_t emptyPlanes() const;
	std::string
	finder() const; // how the cells were found: "spans", "flood", "traversal", "subscripts", or several of these

private:
	void addFigures(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets);
	void addStages(const std::vector<Timeline::Section>& sections);
	void addGenerations(const std::vector<Timeline::Section>& sections);
	Stage& stageOf(const std::string& name, Timeline::Track track, std::uint32_t depth);

	std::vector<Stage> stages_;
	std::vector<GenerationLog> generations_;
	std::vector<double> generation_counts_;
	std::vector<double> cut_cells_, touched_cells_, polygons_, vertices_;
	std::set<std::string> finders_;
};

} // namespace vp::app
