#pragma once

#include "session/sheet_stats.h"

#include <string>
#include <vector>

namespace vp::session
{

// Whether a file's name is that of a flat picture of each sheet: .png, .svg or .pdf.
bool namesPictures(const std::string& output);

// Draws each sheet of a slice flat. `output` has {sheet} in it where there are several. Gives the files.
Result<std::vector<std::string>> writePictures(const Session& session, const view::ResolvedLook& look,
                                               const cut::Cut& slice, const std::vector<SheetStats>& sheets,
                                               const std::string& output);

// Told before a slice is cut: what is wrong with the names of so many pictures.
Result<std::vector<std::string>> pictureNames(const std::string& output, std::size_t sheets);

} // namespace vp::session
