#pragma once

#include "cut/cut.h"
#include "cut/request.h"

#include <vector>

namespace vp::cut
{

/// The step before a plan: finds the sheets of a request that rest, so that only the others are cut.
struct Reuse
{
	std::vector<bool> rests; // per sheet: it is in request.last with exactly the same place, values and corners
	CutRequest moved;        // the request for the other sheets only
	std::vector<const SheetCut*> was; // per sheet of `moved`: the sheet in request.last, null if it is new
};

/// request.last must not be null, and must outlive the result.
Reuse reuseOf(const CutRequest& request);

/// Returns the whole cut: sheets that rest come from request.last, the others from `moved`, in their order.
Cut withResting(const CutRequest& request, const Reuse& reuse, Cut moved);

/// Gives each sheet a number that no other sheet had before.
void numberSheets(Cut& cut);

} // namespace vp::cut
