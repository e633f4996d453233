#pragma once

#include "measure/stats.h"
#include "ranks/join/borders.h"
#include "session/session.h"
#include "vectors/flux.h"
#include "vectors/traces.h"

#include <memory>
#include <optional>
#include <vector>

namespace vp::session
{

// The polygons of a sheet and their figures.
struct SheetStats
{
	mesh::SheetMesh mesh;
	measure::SheetMeasure measure;
	std::optional<mesh::SheetMesh> crinkle{};        // filled if whole cells are shown
	double crinkle_area = 0.0;                       // area of the faces of the whole cells
	std::shared_ptr<const vectors::Traces> traces{}; // particles launched from the sheet; or null
	std::optional<vectors::Flux> flux{};             // flux of vectors through the sheet
	ranks::Borders borders{};                        // what the mesh shares with those of other ranks
	ranks::Borders crinkle_borders{};                // the same of the whole cells
};

// One sheet in two steps. sheetMesh() builds the polygons (section "emit") and launches particles. measureSheet()
// computes the figures (section "measure"). All ranks call these together, and the figures are those of all meshes
// together.
Result<SheetStats> sheetMesh(const Session& session, const cut::Cut& slice, std::size_t sheet);
void measureSheet(const Session& session, const cut::Cut& slice, std::size_t sheet, SheetStats& stats);
// Replaces the second step if only a picture is needed: finds out whether values are missing.
void measureForPicture(const Session& session, const cut::Cut& slice, std::size_t sheet, SheetStats& stats);

// Warns of sheets that lie in the boundary altogether: they cut no cell, so their area is 0. All ranks
// call this.
void reportBoundarySheets(const Session& session, const std::vector<SheetStats>& sheets);

// Returns what an export of the cut contains: its polygons, or the faces of its whole cells.
std::vector<mesh::SheetMesh> exportedMeshes(const std::vector<SheetStats>& sheets);

} // namespace vp::session
