#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "grid/field.h"
#include "grid/imaging.h"
#include "grid/patches.h"
#include "grid/points.h"
#include "grid/structured.h"
#include "grid/unstructured.h"
#include "read/mapping.h"
#include "read/read_warning.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace vp::read
{

// Cells that are checked but not yet built into a grid.
struct CellMesh
{
	grid::Points points;
	grid::CellList cells;
	std::size_t source_cell_count = 0; // if cells.source_cells says of which they are part
	bool curved = false;               // curved cells may stand among them (grid/curved_cells.h)
	Array<std::int32_t> degrees{};     // see grid::CurvedCells
	Array<double> weights{};           // likewise
};

struct CheckedBlock
{
	std::string name;
	std::variant<grid::UniformGrid, grid::RectilinearGrid, grid::CurvilinearGrid, CellMesh> mesh;
	std::vector<grid::Field> fields;
	std::string length_units{};
	grid::Imaging imaging{};
	std::optional<grid::Lattice> hidden_lattice;    // see grid::Block
	std::vector<std::string> arrays_left_out{};     // likewise
	std::shared_ptr<const grid::WholeGrid> whole{}; // likewise, as runs
	std::shared_ptr<grid::CellRuns> runs{};
	std::size_t part = 0; // index of the input's part, if parts were asked for
};

// A part of an input, which can be cut on its own.
struct InputPart
{
	std::size_t cells = 0; // about
	std::size_t block = 0; // its block, if all parts are read at once
};

// The facts about a block whose parts are read on their own. kind: empty if each part is a block or several.
struct WholeLattice
{
	std::string kind;
	std::size_t points = 0;
};

// The checked data from a child.
struct CheckedInput
{
	std::vector<CheckedBlock> blocks;
	std::vector<grid::PatchPolygons> patches;
	std::vector<double> times;
	std::string time_units{};
	std::size_t levels = 1; // resolutions that the file has
	std::vector<ReadWarning> warnings;
	std::vector<std::string> files; // that were read
	std::size_t left_out = 0;
	std::size_t unplaced = 0;       // cells that were left out, since a point of theirs has no place
	std::vector<InputPart> parts{}; // if they were asked for
	std::vector<WholeLattice> wholes{};
	std::uint64_t bytes_read = 0; // from files; 0 if the system does not say
	std::string sandbox{};        // what held the child
};

// Checks that an array has as many numbers as its block has points or cells. Throws Unusable.
void checkField(const grid::Field& field, std::uint64_t points, std::uint64_t cells);

// Returns the number of points along each axis of a lattice that has cells. Throws Unusable.
std::array<std::uint32_t, 3> latticeOf(const std::array<std::uint64_t, 3>& points);

// Checks that the points of an image are finite. Throws Unusable.
void checkImage(const std::array<std::uint32_t, 3>& points, const Vec3& origin, const Vec3& spacing);

// Remembers the files that were read, so that no output takes their places.
void noteFiles(const CheckedInput& input);

// The error of a manifest that fails, for the user.
Error unusable(const std::string& file, const Error& error);

// Checks a manifest and every array in it against the bytes from the child. Nothing is trusted: counts may overflow,
// arrays may lie outside, ids may point anywhere. Cells with coordinates that are no places are left out, with a
// warning. The message of the error is only the reason.
// file: that the child read. Arrays may stay in it; without it, none may. follow: other folders with files that it may
// name, as the child got them. indexed: the file whose index `file` must be; empty if it is none.
Result<CheckedInput> checkManifest(std::string_view text, const SharedBytes& arrays, const SharedBytes& cells,
                                   const std::string& file = {}, const std::string& follow = {},
                                   const std::string& indexed = {});

} // namespace vp::read
