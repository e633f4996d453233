#pragma once

#include "cut/cut.h"
#include "cut/request.h"

#include <vector>

namespace vp::cut
{

/// The step before a plan: which sheets of a request rest, so that only the others are cut.
struct Reuse
{
	std::vector<bool> rests;          // per sheet: it stands in request.last to the last bit, with values and corners
	CutRequest moved;                 // the request for the others alone
	std::vector<const SheetCut*> was; // per sheet of `moved`: as it was in request.last, null where it is new
};

/// request.last is not null, and outlives what is returned.
Reuse reuseOf(const CutRequest& request);

/// The whole cut: sheets that rest from request.last, the others, in their order, from `moved`.
Cut withResting(const CutRequest& request, const Reuse& reuse, Cut moved);

/// Gives each sheet a number that no other has had.
void numberSheets(Cut& cut);

} // namespace vp::cut
