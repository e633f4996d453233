#pragma once

#include "find/listed.h"
#include "find/plan.h"
#include "find/threshold.h"
#include "find/visited.h"
#include "grid/field_choice.h"
#include "mesh/clip.h"
#include "mesh/hanging_vertices.h"
#include "probe/probe.h"
#include "seed/seeds.h"

#include <memory>
#include <optional>
#include <vector>

namespace vp
{
class Timeline;
}

namespace vp::cut
{

struct Cut; // cut.h

/// Says where to cut, and how.
struct CutRequest
{
	probe::Probe probe;
	mesh::Corners corners = mesh::Corners::keep; // what happens at the corners of windows
	mesh::Hanging hanging = mesh::Hanging::keep;
	std::optional<grid::FieldChoice> field;
	std::vector<std::optional<grid::FieldChoice>> sheet_fields; // per sheet, replaces `field`; or empty
	seed::SeedOptions seeds;
	// Per sheet, in place of seeds that would be looked for; or null.
	const std::vector<seed::SheetSeeds>* given_seeds = nullptr;
	std::optional<find::Threshold> threshold; // range of the field's values; the search does not pass cells outside it
	bool in_generations = false;              // each cell is met in its generation, which SheetCut knows
	bool device_first = false;                // a device was asked for by name, see find::PlanRequest
	std::optional<find::Strategy> strategy;   // for all sheets and blocks; an error if it is not possible
	// Other cuts of these blocks will follow, so it pays to build neighbors, which one cut would not need.
	bool another_follows = false;
	find::VisitedSet visited = find::VisitedSet::stamps;
	// Replaces the sheets of the probe. It needs no search, so windows and seeds have no effect.
	std::optional<find::ListedSurface> surface;
	// A cut of the same blocks and values by a request that differed only in the probe, or null. Sheets with exactly
	// the same place are taken from it and not cut again.
	std::shared_ptr<const Cut> last;
	// Sections "seed", "traverse" with "classify" and "expand" of each generation, "emit". It must outlive the cut.
	Timeline* timeline = nullptr;

	const std::optional<grid::FieldChoice>& fieldOf(std::size_t sheet) const
	{
		return sheet_fields.empty() ? field : sheet_fields[sheet];
	}
	/// Returns what a plan needs to know. The result refers to this request.
	find::PlanRequest forPlan() const
	{
		return {.sheets = probe.sheets,
		        .surface = surface ? &*surface : nullptr,
		        .has_threshold = threshold.has_value(),
		        .seed_mode = seeds.mode,
		        .looks_for_hot_spot = seeds.outside != seed::OutsidePolicy::nearest,
		        .another_follows = another_follows,
		        .in_generations = in_generations,
		        .device_first = device_first,
		        .strategy = strategy};
	}
};

} // namespace vp::cut
