#pragma once

#include "cut/request.h"
#include "grid/block.h"
#include "view/view_spec.h"

#include <cstdint>
#include <vector>

namespace vp::session
{

/// Returns true if a cut by the settings looks at the values where it lies, and nowhere else.
bool meetsFewValues(const view::ViewSpec& spec);

/// Returns true if frames by the settings look at nothing but cells that the sheets meet, where they are in the file.
bool looksAtCutAlone(const view::ViewSpec& spec);
/// The same for these blocks: a logarithmic scale begins at a value that old packs do not tell.
bool looksAtCutAlone(const view::ViewSpec& spec, const grid::BlockSet& blocks);
/// Returns true if frames by the settings look at nothing but cells near planes, and at their neighbors among these: at
/// those that the sheets meet, and that lie in the boxes of contours.
bool looksNearPlanes(const view::ViewSpec& spec);
/// Returns true if the files tell the least value above 0 of each array that they have in runs.
bool knowsLeastPositive(const grid::BlockSet& blocks);

/// For each block the numbers of the runs that some sheet of a cut may meet, ascending. Empty for blocks without runs.
using RunsOfBlocks = std::vector<std::vector<std::uint32_t>>;
RunsOfBlocks runsMet(const grid::BlockSet& blocks, const cut::CutRequest& request);
/// The same, and those that the boxes of contours may meet. All sheets are planes.
RunsOfBlocks runsNear(const grid::BlockSet& blocks, const cut::CutRequest& request, const view::ContourSpec& contour);

} // namespace vp::session
