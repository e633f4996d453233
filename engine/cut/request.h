#pragma once

#include "find/listed.h"
#include "find/plan.h"
#include "find/threshold.h"
#include "find/visited.h"
#include "grid/field_choice.h"
#include "mesh/clip.h"
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

/// What is to be cut.
struct CutRequest
{
	probe::Probe probe;
	mesh::Corners corners = mesh::Corners::keep; // of windows
	std::optional<grid::FieldChoice> field;
	std::vector<std::optional<grid::FieldChoice>> sheet_fields; // per sheet, in place of `field`; or empty
	seed::SeedOptions seeds;
	std::optional<find::Threshold> threshold; // of the field's values: the search ends at cells outside
	find::Finder finder = find::Finder::traversal;
	std::optional<find::Strategy> strategy; // for all sheets and blocks; an error where it cannot be had
	// Other cuts of these blocks will follow, so that it pays to build neighbors where a first cut would do without.
	bool another_follows = false;
	find::VisitedSet visited = find::VisitedSet::stamps;
	// Takes the place of the probe's sheets. It needs no search, and windows and seeds mean nothing to it.
	std::optional<find::ListedSurface> surface;
	// A cut by a request that differed from this one in the probe alone, over the same blocks and values; or null.
	// Its sheets that stand where they stood, to the last bit, are taken from it and not cut again.
	std::shared_ptr<const Cut> last;
	// Sections "seed", "traverse" with "classify" and "expand" of each generation, "emit". Must outlive the cutting.
	Timeline* timeline = nullptr;

	const std::optional<grid::FieldChoice>& fieldOf(std::size_t sheet) const
	{
		return sheet_fields.empty() ? field : sheet_fields[sheet];
	}
	/// What a plan has to know. It refers to this request.
	find::PlanRequest forPlan() const
	{
		return {.sheets = probe.sheets,
		        .surface = surface ? &*surface : nullptr,
		        .has_threshold = threshold.has_value(),
		        .seed_mode = seeds.mode,
		        .looks_for_hot_spot = seeds.outside != seed::OutsidePolicy::nearest,
		        .another_follows = another_follows,
		        .finder = finder,
		        .strategy = strategy};
	}
};

} // namespace vp::cut
