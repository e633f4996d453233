#pragma once

#include "grid/cell_runs.h"
#include "probe/probe.h"
#include "view/view_spec.h"

#include <cstdint>
#include <vector>

namespace vp::session
{

/// Returns true if frames by the settings look at nothing but cells that the sheets meet, where they are in the file.
bool looksAtCutAlone(const view::ViewSpec& spec);

/// Returns the numbers of the runs that some sheet of a probe may meet, ascending.
std::vector<std::uint32_t> runsMet(const grid::CellRuns& runs, const probe::Probe& probe);

} // namespace vp::session
