#pragma once

#include "session/sheet_stats.h"

#include <string>
#include <vector>

namespace vp::picture
{

// Returns true if the name is that of a flat picture: .png, .svg or .pdf.
bool namesPictures(const std::string& output);

// Draws a flat picture of each sheet of a cut. `output` contains {sheet} if there are several sheets. Returns the file
// names.
Result<std::vector<std::string>> writePictures(const session::Session& session, const view::ResolvedLook& look,
                                               const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
                                               const std::string& output);

// Checks the names for this number of pictures, before anything is cut.
Result<std::vector<std::string>> pictureNames(const std::string& output, std::size_t sheets);

} // namespace vp::picture
