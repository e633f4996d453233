#pragma once

#include "exit_code.h"
#include "session/frame.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace vp::app
{

// Returns what the --stats document says about the sheets.
nlohmann::json sheetsJson(const session::Session& session, const cut::Cut& slice,
                          const std::vector<session::SheetStats>& sheets);

// Returns what the last frame read of arrays that stay in their files; null if there are none.
nlohmann::json partsJson(const session::Session& session);

// Returns the first part of a document: input, grid, array, device and classifier.
nlohmann::json inputJson(const session::Session& session);

// Returns a --stats document with the keys of `what`. Every document also has input, grid, device and times.
std::string statsDocument(const session::Session& session, const nlohmann::json& what);

// Returns the --stats document of a cut. Scripts rely on its keys: add keys, but never rename one.
std::string statsJson(const session::Session& session, const session::Frame& frame);

// Returns the same as text for people.
std::string statsTable(const session::Session& session, const session::Frame& frame);

// Returns what the document says about contours.
nlohmann::json contoursJson(const session::Session& session, const session::Contours& contours);

// Checks before long work whether a file can be written to this path, and leaves nothing behind. An empty path and "-"
// always pass.
Status checkWritable(const std::string& path);

// Ends a command: writes the document to `path` ("-" is standard output; an empty path does nothing). If this fails,
// the files among `outputs` are removed, so that a failed command leaves nothing behind.
Result<ExitCode> writeStats(const std::string& path, const std::vector<std::string>& outputs,
                            const std::string& document);

} // namespace vp::app
