#pragma once

#include "exit_code.h"
#include "measure/stats.h"
#include "session.h"
#include "vectors/traces.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// A sheet's figures: what was cut, and what it shows.
struct SheetStats
{
	mesh::SheetMesh mesh;
	measure::SheetMeasure measure;
	std::optional<mesh::SheetMesh> crinkle{};        // where whole cells are wanted
	std::shared_ptr<const vectors::Traces> traces{}; // launched from it; null where nothing is
	std::optional<double> flux{};                    // of vectors, through it
};

Result<std::vector<SheetStats>> sheetStats(const Session& session, const cut::Cut& slice);
// Of one sheet, in two halves: its polygons, section "emit", and what is launched from them; what they show, section
// "measure".
Result<SheetStats> sheetMesh(const Session& session, const cut::Cut& slice, std::size_t sheet);
void measureSheet(const Session& session, const cut::Cut& slice, std::size_t sheet, SheetStats& stats);
// In place of the second where only a picture is wanted: it tells whether values are missing.
void measureForPicture(const Session& session, const cut::Cut& slice, std::size_t sheet, SheetStats& stats);

// What a slice's export holds: its polygons, or the faces of its whole cells.
std::vector<mesh::SheetMesh> exportedMeshes(const std::vector<SheetStats>& sheets);

// What the --stats document says of sheets.
nlohmann::json sheetsJson(const Session& session, const cut::Cut& slice, const std::vector<SheetStats>& sheets);

// What a document says first: input, grid, array, device and classifier.
nlohmann::json inputJson(const ProbeOptions& options, const Session& session);

// A --stats document that says `what`, key by key: input, grid, device and times are told in any.
std::string statsDocument(const ProbeOptions& options, const Session& session, const nlohmann::json& what);

// The --stats document of a slice. Scripts rely on its keys: add to them, never rename one. more: further keys.
std::string statsJson(const ProbeOptions& options, const Session& session, const cut::Cut& slice,
                      const std::vector<SheetStats>& sheets, nlohmann::json more);

// The same for people.
std::string statsTable(const Session& session, const cut::Cut& slice, const std::vector<SheetStats>& sheets);

// "gpu", "cpu", or "mixed" where a block stayed with the CPU for a limit of the device.
const char* classifierName(const Session& session);

// The end of a command: writes the document to `path` ("-" is standard output, "" does nothing). When that fails the
// command leaves nothing behind: those of `outputs` that are files are removed.
// Whether a file can be written there, told before long work; nothing is left of the try. "" and - always fit.
Status checkWritable(const std::string& path);

Result<ExitCode> writeStats(const std::string& path, const std::vector<std::string>& outputs,
                            const std::string& document);

} // namespace vp::app
