#pragma once

#include "base/timeline.h"
#include "report/stats_json.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace vp::app
{

// How long a part of the work took on each plane of a sweep.
struct Stage
{
	std::string name;
	Timeline::Track track;
	std::uint32_t depth; // of stages that it is a part of; of the GPU's 0
	std::vector<double> ms;
};

// Generation k of the traversals on those planes that have one: an entry a plane.
struct GenerationLog
{
	std::vector<double> cells; // in the front, over all sheets
	std::vector<double> classify_ms;
	std::vector<double> expand_ms;
	std::vector<double> gpu_ms; // empty where the device classified nothing, or keeps no time
};

// What a profile gathers, plane by plane. Memory: some dozens of numbers a plane.
class ProfileLog
{
public:
	// sections: all that a plane's work put on the timeline.
	void add(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
	         const std::vector<Timeline::Section>& sections);

	std::size_t planes() const { return cut_cells_.size(); }
	const std::vector<Stage>& stages() const { return stages_; } // in the order of their beginnings
	std::vector<double> msOf(const std::string& stage) const;    // of the CPU's, per plane
	std::vector<double> gpuMs() const;                           // of all the GPU's together, per plane
	const std::vector<GenerationLog>& generations() const { return generations_; }
	const std::vector<double>& generationCounts() const { return generation_counts_; } // per plane

	// Per plane, over all sheets. Cells are those of the grid: where curved cells were cut into linear ones, these.
	const std::vector<double>& cutCells() const { return cut_cells_; }
	const std::vector<double>& touchedCells() const { return touched_cells_; }
	const std::vector<double>& polygons() const { return polygons_; }
	const std::vector<double>& vertices() const { return vertices_; }
	std::size_t emptyPlanes() const;
	std::string finder() const; // how the cells were found: "spans", "flood", "traversal", "subscripts", or several

private:
	void addFigures(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets);
	void addStages(const std::vector<Timeline::Section>& sections);
	void addGenerations(const std::vector<Timeline::Section>& sections);
	Stage& stageOf(const Timeline::Section& section);

	std::vector<Stage> stages_;
	std::vector<GenerationLog> generations_;
	std::vector<double> generation_counts_;
	std::vector<double> cut_cells_, touched_cells_, polygons_, vertices_;
	std::set<std::string> finders_;
};

} // namespace vp::app
