#pragma once

#include "cut/cutter.h"

#include <cstddef>
#include <vector>

namespace vp::cut
{

// Each sheet gets a number that no other has had.
void numberSheets(Cut& slice);

// Which of a request's sheets, placed, stand in request.last to the last bit, with the same values and corners.
std::vector<bool> unmovedSheets(const CutRequest& request);

// Which of a request's sheets cut by a form in place of their plane.
std::vector<bool> sheetsWithForm(const CutRequest& request);

// The request for the others alone.
CutRequest withoutSheets(const CutRequest& request, const std::vector<bool>& left_out);

// The whole slice, with some sheets that moved: unmoved ones from request.last, the others, in their order, from
// `moved`.
Cut joinSheets(const CutRequest& request, const std::vector<bool>& unmoved, Cut moved);

} // namespace vp::cut
