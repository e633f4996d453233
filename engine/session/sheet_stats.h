#pragma once

#include "measure/overlap.h"
#include "measure/stats.h"
#include "measure/value_areas.h"
#include "mesh/nearest_parts.h"
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
	std::optional<mesh::SheetMesh> crinkle{}; // filled if whole cells are shown
	// Filled if blocks without the array lie where others have it: what pictures show, which is the polygons of others.
	std::shared_ptr<const mesh::SheetMesh> shown{};
	double area_left_out = 0.0; // area of the polygons that they leave out
	// Filled if the array names categories of points: the polygons that pictures show, parted between nearest points.
	std::shared_ptr<const mesh::NearestParts> parts{};
	std::optional<measure::ValueAreas> value_areas{}; // filled if the array names at most kMaxCategories categories
	std::optional<measure::Overlap> overlap{};        // where inputs overlap; filled with the figures
	double crinkle_area = 0.0;                        // area of the faces of the whole cells
	std::shared_ptr<const vectors::Traces> traces{};  // particles launched from the sheet; or null
	std::optional<vectors::Flux> flux{};              // flux of vectors through the sheet
	ranks::Borders borders{};                         // what the mesh shares with those of other ranks
	ranks::Borders crinkle_borders{};                 // the same of the whole cells

	// Cells of different sizes meet between ranks, and nothing else here holds.
	bool hangs() const { return borders.hangs || crinkle_borders.hangs; }
};

// One sheet in two steps. sheetMesh() builds the polygons (section "emit") and launches particles. measureSheet()
// computes the figures (section "measure"). All ranks call these together, and the figures are those of all meshes
// together.
Result<SheetStats> sheetMesh(const Session& session, const cut::Cut& slice, std::size_t sheet);
void measureSheet(const Session& session, const cut::Cut& slice, std::size_t sheet, SheetStats& stats);
/// Returns a mark for each image that lacks an array, and lies by more than half in an image of another input that has
/// it, such as a segmentation over the scan that is shown. Pictures leave these out; they would hide the other. Nothing
/// if there is none.
std::vector<bool> blocksCoveredByOthers(const grid::BlockSet& blocks, const grid::FieldChoice& field);

/// Returns the area of each value of an array that names categories, at most kMaxCategories of them; otherwise nothing.
/// blocks: those that the cut refers to. parts: those of the mesh, or null. All ranks call this.
std::optional<measure::ValueAreas> valueAreas(const Session& session, const grid::BlockSet& blocks,
                                              const mesh::SheetMesh& mesh, const grid::FieldChoice& field,
                                              const mesh::NearestParts* parts);
// Replaces the second step if only a picture is needed: finds out whether values are missing.
void measureForPicture(const Session& session, const cut::Cut& slice, std::size_t sheet, SheetStats& stats);

// Warns of sheets that lie in the boundary altogether: they cut no cell, so their area is 0. All ranks
// call this.
void reportBoundarySheets(const Session& session, const std::vector<SheetStats>& sheets);

/// Returns where the inputs of a session lie over each other on a sheet: nothing on surfaces that are no plane, and
/// nothing if several processes hold the inputs.
measure::Overlap overlapOf(const Session& session, const cut::Cut& slice, std::size_t sheet, const SheetStats& stats);
/// Returns true if so much of a sheet counts twice, because inputs overlap, that it is no matter of their rims.
bool isMuch(const measure::Overlap& overlap);
/// Warns of the inputs that overlap the most.
void reportOverlap(const Session& session, const cut::Cut& slice, const std::vector<SheetStats>& sheets);
/// Says what would read less where the last frame met much of a large array that lies in rows across it.
void reportRowsAcross(const Session& session);

// Returns what an export of the cut contains: its polygons, or the faces of its whole cells.
std::vector<mesh::SheetMesh> exportedMeshes(const std::vector<SheetStats>& sheets);

} // namespace vp::session
