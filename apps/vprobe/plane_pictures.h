#pragma once

#include "look_options.h"
#include "stats_json.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace vp::app
{

// Whether -o names a flat picture of each sheet: .png, .svg or .pdf.
bool namesPictures(const std::string& output);

// Of options that have no say where no picture is drawn: an error names the first that the command line has, why there
// is none ("-o a.vtp is none") and what would draw one.
Status refuseLook(const CLI::App& command, const std::string& why, const char* remedy);

// Draws each sheet of a slice flat. `output` has {sheet} in it where there are several. Gives the files.
Result<std::vector<std::string>> writePictures(const Session& session, const std::vector<std::string>& inputs,
                                               const LookChoice& look, const cut::Cut& slice,
                                               const std::vector<SheetStats>& sheets, const std::string& output);

// Told before a slice is cut: what is wrong with the names of so many pictures.
Result<std::vector<std::string>> pictureNames(const std::string& output, std::size_t sheets);

} // namespace vp::app
