#pragma once

#include "measure/stats.h"
#include "session/session.h"
#include "vectors/traces.h"

#include <memory>
#include <optional>
#include <vector>

namespace vp::session
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

} // namespace vp::session
