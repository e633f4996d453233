#pragma once

#include "slice/slicer.h"

#include <cstddef>
#include <vector>

namespace vp::slice
{

// Each sheet gets a number that no other has had.
void numberSheets(Slice& slice);

// Which of a request's sheets, placed, stand in request.last to the last bit, with the same values and corners.
std::vector<bool> unmovedSheets(const SliceRequest& request);

// Which of a request's sheets cut by a form in place of their plane.
std::vector<bool> sheetsWithForm(const SliceRequest& request);

// The request for the others alone.
SliceRequest withoutSheets(const SliceRequest& request, const std::vector<bool>& left_out);

// The whole slice, with some sheets that moved: unmoved ones from request.last, the others, in their order, from
// `moved`.
Slice joinSheets(const SliceRequest& request, const std::vector<bool>& unmoved, Slice moved);

} // namespace vp::slice
