#pragma once

#include "find/block_cut.h"
#include "find/listed.h"
#include "grid/block.h"
#include "grid/field_choice.h"
#include "mesh/clip.h"
#include "mesh/sheet_mesh.h"
#include "probe/sheet.h"
#include "seed/seeds.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::classify
{
struct SheetRecords; // a sheet's polygons in device memory (gpu_records.h)
}

namespace vp::cut
{

/// One sheet's share of a cut.
struct SheetCut
{
	probe::Sheet shown; // as the probe places it in the world
	probe::Sheet sheet; // what it shows: where fx does nothing the same, see probe::content()
	mesh::Corners corners = mesh::Corners::keep;
	std::optional<grid::FieldChoice> field;
	seed::SheetSeeds seeds;
	std::vector<find::BlockCut> cuts;                // per block
	std::shared_ptr<classify::SheetRecords> records; // planes on a device only: the polygons as they are drawn
	std::optional<find::ListedSurface> surface;      // shown in place of the sheet, whose frame means nothing then
	// Of the cut: sheets of two cuts with one number are the same, and over the same values so are their meshes.
	std::uint64_t number = 0;

	bool isPlane() const { return !surface && !sheet.form; }
};

/// Of a sheet that is no plane: "i=12.5", "sphere:2".
std::string surfaceName(const SheetCut& sheet);

/// What a Cutter gives for a request.
struct Cut
{
	std::vector<SheetCut> sheets;
	std::vector<std::string> warnings; // for the user, such as why cells were left to the CPU

	/// The indexed mesh of a sheet within its window, built on the CPU.
	mesh::SheetMesh mesh(const grid::BlockSet& blocks, std::size_t sheet) const;
	/// The whole cells that a sheet shows in its window, see mesh/crinkle.h.
	mesh::SheetMesh crinkle(const grid::BlockSet& blocks, std::size_t sheet) const;
};

} // namespace vp::cut
