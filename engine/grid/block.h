#pragma once

#include "base/result.h"
#include "base/vec.h"
#include "grid/block_tree.h"
#include "grid/boundary.h"
#include "grid/cell_runs.h"
#include "grid/field.h"
#include "grid/imaging.h"
#include "grid/interfaces.h"
#include "grid/lattice_cells.h"
#include "grid/patches.h"
#include "grid/structured.h"
#include "grid/unstructured.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace vp::grid
{

struct CurvedCells; // curved_cells.h

using AnyGrid = std::variant<UniformGrid, RectilinearGrid, CurvilinearGrid, UnstructuredGrid>;

// An unstructured grid that its file has in parts, as the file describes it.
struct WholeGrid
{
	std::size_t points = 0; // those of several parts count once
	std::size_t cells = 0;
	Box bounds;
	std::vector<Vec3> farthest; // from their center (farthest_points.h); empty if the file does not say
	parts::PartUse parts;
	Field cell_numbers; // by sourceCell(): the number in the file that the parts were made of
};

// A grid with the arrays that live on it.
struct Block
{
	std::string name;
	AnyGrid grid;
	std::vector<Field> fields;
	std::string length_units{}; // units of the coordinates, as the file names them; mostly empty
	Imaging imaging{};
	std::uint32_t input = 0; // number of the input that holds it, of several
	// Identifies the coordinates and cells of the file. If two blocks of one input at two times have the same number,
	// they have the same grid. 0: not known.
	std::uint64_t geometry = 0;
	// The arrays in the file that nobody asked for, as "point:NAME" or "cell:NAME" (read::ArrayWish).
	std::vector<std::string> arrays_left_out{};
	// If the grid is a lattice without its hidden cells, it is unstructured. Then this is that lattice; sourceCell()
	// and sourcePoint() give numbers in it.
	std::optional<Lattice> hidden_lattice;
	// Set if the file has the grid in parts. Then `bounds` are those of the whole.
	std::shared_ptr<const WholeGrid> whole{};
	// Set if its cells are read when somebody needs them. Until then it is listed, and lacks all that was not fetched.
	std::shared_ptr<CellRuns> runs{};
	// Set if curved cells are refined where they are cut. Then `grid` has only the corners of these cells.
	std::shared_ptr<const CurvedCells> curved{};

	// Built by finishBlock().
	Box bounds;
	BoundaryIndex boundary;
	std::vector<CellId>
	    vantage; // cells where fence hopping starts: centers of sides, or boundary cells spread over the block
	std::vector<CellId>
	    inverted; // cells where the grid may be folded; they can close off a piece, so they are seeds (folds.h)
	bool knows_folds =
	    true; // false for a curvilinear grid where nobody looked: then every row gives seeds (seed/row_seeds.h)
	BlockTree inverted_tree;                     // over `inverted`
	std::shared_ptr<LazyBlockTree> tree;         // over all cells, for treeOf()
	std::shared_ptr<LazyCellPlaces> cell_places; // only for a hidden lattice, for latticeCellsOf()
};

// Chooses the order of a curvilinear grid's axes (lattice_axes.h) and finds categorical fields, bounds, the boundary
// index, vantage points and inverted cells, on all cores. A listed grid has no neighbors, so it gets only categorical
// fields and bounds.
//
// for_one_cut: a curvilinear grid keeps the order of its file, and nobody looks for folds. Both take longer than one
// cut.
void finishBlock(Block& block, bool for_one_cut = false);

/// Returns true if the cells of the block know their neighbors, as in every grid but a listed one (unstructured.h).
bool hasNeighbors(const Block& block);

// Returns a block with other values on the same grid, such as those of another time.
void replaceFields(Block& block, std::vector<Field> fields);

// Returns the block tree over all cells. The first call builds it (see BlockTree for time and memory). Thread safe.
// Copies of a block share the tree. Call finishBlock() before.
const BlockTree& treeOf(const Block& block);

// The contents of one file or several.
struct BlockSet
{
	std::vector<Block> blocks;
	std::vector<double> times;  // in the input, ascending; empty if it has no times
	std::string time_units{};   // units of the times, as the files name them; empty if they differ or are not named
	std::size_t levels = 1;     // resolutions that the files have, of which one is here
	std::size_t left_out = 0;   // cells of dimension below three
	std::size_t unplaced = 0;   // cells left out because a point of theirs is not finite
	Interfaces interfaces;      // set by matchInterfaces() when all blocks are finished
	bool matches_seams = true;  // false: nobody has called matchInterfaces(), since there is to be one cut
	std::vector<Patch> patches; // named in the files, if somebody asked for them

	// Counts of the grids, which are walked and cut.
	std::size_t cellCount() const;
	std::size_t pointCount() const;
	// Counts of the files. They are smaller if a reader cut curved cells into linear ones.
	std::size_t sourceCellCount() const;
	std::size_t sourcePointCount() const;
	Box bounds() const;
	// Returns what the files say of a picture, if all say the same.
	Imaging imaging() const;
	// Returns "image", "rectilinear", "curvilinear" or "unstructured"; "block-structured" for several structured
	// blocks; "hybrid" for a mixture.
	const char* kind() const;
};

// Returns the number that the user knows a cell by: that in the file, or in the file that was packed.
std::int64_t cellNumber(const Block& block, CellId cell);

/// Returns true if all cells are left in files (Block::runs) that have the values at a time of the set, by its index.
bool hasTimeInRuns(const BlockSet& blocks, std::size_t time);

/// Returns true if cells are left in the file (Block::runs). Whoever needs others than he has fetched calls
/// readAllParts().
bool lacksParts(const BlockSet& blocks);
/// Reads what is left in the file. Throws parts::Unreadable, and parts::Stopped.
void readAllParts(BlockSet& blocks);
/// Takes a block for whole whose cells were in the file. Its parts count as they were used until now.
void leaveFile(Block& block);

/// Returns a block like one that is left in its file, with the cells of some runs (ascending) alone, which know their
/// neighbors among these. They were fetched. `bounds` stay those of the whole; the boundary is that of these cells.
Block linkedRuns(const Block& block, std::span<const std::uint32_t> runs);

/// Returns true if all blocks know their neighbors.
bool hasNeighbors(const BlockSet& blocks);

/// Returns true if an array stays in its file (Field::stored).
bool staysInFile(const BlockSet& blocks);

/// Returns what was read of such arrays since startCounting(), and of grids in parts, or nothing if there are none.
std::optional<parts::PartUse> partUse(const BlockSet& blocks);
// Whoever fetches runs begins to count them himself.
void startCountingParts(const BlockSet& blocks);

/// Returns true if matchInterfaces() has run, or if the blocks are known to have no interfaces. Otherwise a mesh finds
/// the few interfaces that it needs (mesh/mesh_seams.h).
bool knowsSeams(const BlockSet& blocks);

/// Returns true if nothing has been left out for the sake of one cut: neighbors, seams, folds, the order of axes.
bool isComplete(const BlockSet& blocks);

/// Links the listed grids of a set (unstructured.h), finishes their blocks and matches interfaces, on all cores. Also
/// finishes those that were finished for one cut, unless there is to be one cut. The cells and points of these blocks
/// get other ids, so earlier results are no longer valid. Does nothing if the set is complete. Throws like
/// UnstructuredGrid::build() and readAllParts().
void buildNeighbors(BlockSet& blocks, bool for_one_cut = false);

// Throws std::logic_error if an invariant is broken: neighbors that do not know each other, ids out of range, boxes
// that do not contain their faces. For tests.
void validate(const Block& block);

} // namespace vp::grid
