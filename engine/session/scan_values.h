#pragma once

#include "session/session.h"

#include <optional>
#include <utility>

namespace vp::session
{

/// Returns true if pictures of an array begin in gray: the file is one of a scanner or a microscope, or the array is an
/// image of integers of 8 or 16 bits. Arrays that name categories do not.
bool beginsGray(const grid::BlockSet& blocks, const std::optional<grid::FieldChoice>& field);

/// Returns the values that are black and white at first: the window that the file names, else those below and above
/// which 0.5 percent of all values lie. Nothing if the array does not begin in gray, or if these values are the same.
/// span: that of the array over all processes. All processes call this together.
std::optional<std::pair<double, double>> windowOfScan(const Session& session, const grid::FieldChoice& field,
                                                      const grid::ValueSpan& span);

} // namespace vp::session
