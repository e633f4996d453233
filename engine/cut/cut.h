#pragma once

#include "find/block_cut.h"
#include "find/listed.h"
#include "grid/block.h"
#include "grid/field_choice.h"
#include "mesh/clip.h"
#include "mesh/hanging_vertices.h"
#include "mesh/sheet_mesh.h"
#include "probe/sheet.h"
#include "seed/seeds.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vp::classify
{
struct SheetRecords; // a sheet's polygons in device memory (gpu_records.h)
}

namespace vp::cut
{

/// The part of a cut that belongs to one sheet.
struct SheetCut
{
	probe::Sheet shown; // at its place in the world
	probe::Sheet sheet; // the place that it shows; the same unless fx magnifies, see probe::content()
	mesh::Corners corners = mesh::Corners::keep;
	mesh::Hanging hanging = mesh::Hanging::keep;
	std::optional<grid::FieldChoice> field;
	seed::SheetSeeds seeds;
	std::vector<find::BlockCut> cuts;                // per block
	std::shared_ptr<classify::SheetRecords> records; // only for planes on a device: the polygons as they are drawn
	std::optional<find::ListedSurface> surface; // shown in place of the sheet; then the sheet's frame means nothing
	// Number of the cut. Sheets of two cuts with the same number are the same, and with the same values so are their
	// meshes.
	std::uint64_t number = 0;

	bool isPlane() const { return !surface && !sheet.form; }
};

/// Returns the name of a sheet that is not a plane, such as "i=12.5" or "sphere:2".
std::string surfaceName(const SheetCut& sheet);

/// Counts of the cells refined for a cut (refine/refiner.h).
struct RefinedCounts
{
	std::size_t looked_at = 0;  // curved cells whose nodes were looked at
	std::size_t cells = 0;      // curved cells that the sheets may meet, which were refined
	std::size_t parts = 0;      // linear cells that they were refined to, where the sheets meet them
	std::size_t unfinished = 0; // curved cells that would have got too many parts, and are shown as far as refined
};

/// The result of a Cutter for a request.
struct Cut
{
	std::vector<SheetCut> sheets;
	// Where curved cells were refined: their linear parts where the sheets meet them. The sheets refer to these blocks
	// in place of those that were cut.
	std::shared_ptr<const grid::BlockSet> refined{};
	RefinedCounts refined_counts{};
	std::vector<std::string> warnings; // for the user, such as why cells were left to the CPU

	/// Returns the blocks that the sheets refer to. blocks: those that were cut.
	const grid::BlockSet& blocksOf(const grid::BlockSet& blocks) const { return refined ? *refined : blocks; }

	/// Builds the indexed mesh of a sheet inside its window, on the CPU.
	mesh::SheetMesh mesh(const grid::BlockSet& blocks, std::size_t sheet) const;
	/// Builds the mesh of the whole cells that a sheet shows in its window, see mesh/crinkle.h. left_out: cells that
	/// are not shown, though a face of theirs lies in the plane.
	mesh::SheetMesh crinkle(const grid::BlockSet& blocks, std::size_t sheet,
	                        std::span<const mesh::BlockCell> left_out = {}) const;
};

} // namespace vp::cut
