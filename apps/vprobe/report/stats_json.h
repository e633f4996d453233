#pragma once

#include "exit_code.h"
#include "session/cut_frame.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace vp::app
{

// What the --stats document says of sheets.
nlohmann::json sheetsJson(const session::Session& session, const cut::Cut& slice,
                          const std::vector<session::SheetStats>& sheets);

// What a document says first: input, grid, array, device and classifier.
nlohmann::json inputJson(const session::Session& session);

// A --stats document that says `what`, key by key: input, grid, device and times are told in any.
std::string statsDocument(const session::Session& session, const nlohmann::json& what);

// The --stats document of a slice. Scripts rely on its keys: add to them, never rename one.
std::string statsJson(const session::Session& session, const session::CutFrame& frame);

// The same for people.
std::string statsTable(const session::Session& session, const session::CutFrame& frame);

// What it says of contours.
nlohmann::json contoursJson(const session::Session& session, const session::Contours& contours);

// Whether a file can be written there, told before long work; nothing is left of the try. "" and - always fit.
Status checkWritable(const std::string& path);

// The end of a command: writes the document to `path` ("-" is standard output, "" does nothing). When that fails the
// command leaves nothing behind: those of `outputs` that are files are removed.
Result<ExitCode> writeStats(const std::string& path, const std::vector<std::string>& outputs,
                            const std::string& document);

} // namespace vp::app
