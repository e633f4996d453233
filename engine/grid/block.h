#pragma once

#include "base/result.h"
#include "base/vec.h"
#include "grid/block_tree.h"
#include "grid/boundary.h"
#include "grid/field.h"
#include "grid/interfaces.h"
#include "grid/lattice_cells.h"
#include "grid/patches.h"
#include "grid/structured.h"
#include "grid/unstructured.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vp::grid
{

using AnyGrid = std::variant<UniformGrid, RectilinearGrid, CurvilinearGrid, UnstructuredGrid>;

// A grid with the arrays that live on it.
struct Block
{
	std::string name;
	AnyGrid grid;
	std::vector<Field> fields;
	std::string length_units{}; // of the coordinates, as the file names them; mostly empty
	// Of the file's coordinates and cells, where a file gave them: blocks of one input at two times have the same grid
	// where this number is the same. 0: not known.
	std::uint64_t geometry = 0;
	// The arrays of the file that were not asked for, as "point:NAME" or "cell:NAME" (read::ArrayWish).
	std::vector<std::string> arrays_left_out{};
	// Where the grid is a lattice without its hidden cells, and so unstructured: that lattice, whose numbers
	// sourceCell() and sourcePoint() give.
	std::optional<Lattice> hidden_lattice;

	// Built by finishBlock().
	Box bounds;
	BoundaryIndex boundary;
	std::vector<CellId> vantage;  // cells from which fence hopping starts: side centers, or spread boundary cells
	std::vector<CellId> inverted; // where the grid may be folded: they can close off a piece, so they seed (folds.h)
	bool knows_folds = true;      // else a curvilinear grid: seeds come from every row (seed/row_seeds.h)
	BlockTree inverted_tree;      // over those
	std::shared_ptr<LazyBlockTree> tree;         // over all cells, for treeOf()
	std::shared_ptr<LazyCellPlaces> cell_places; // of a hidden lattice, for latticeCellsOf()
};

// The order of a curvilinear grid's axes (lattice_axes.h), categorical fields, bounds, boundary index, vantage points
// and inverted cells, on all cores. Of a listed grid, which has no neighbors, only categorical fields and bounds.
//
// for_one_cut: a curvilinear grid stays in the order of its file, and folds are not looked for. That takes longer than
// a cut without either.
void finishBlock(Block& block, bool for_one_cut = false);

/// Whether the cells of the block know their neighbors: the grid is not a listed one (unstructured.h).
bool hasNeighbors(const Block& block);

// Other values over the same grid, as at another time.
void replaceFields(Block& block, std::vector<Field> fields);

// The block tree over all cells, built when it is asked for first (see BlockTree for time and memory). Thread safe;
// copies of a block share it. finishBlock() has been called.
const BlockTree& treeOf(const Block& block);

// What a file or several files hold.
struct BlockSet
{
	std::vector<Block> blocks;
	std::vector<double> times;  // that the input offers, ascending; empty where it knows no time
	std::size_t left_out = 0;   // cells of dimension below three
	Interfaces interfaces;      // built by matchInterfaces(), once all blocks are finished
	bool matches_seams = true;  // else nobody will call that
	std::vector<Patch> patches; // that the files name, where they were asked for

	// Of the grids, which are what is walked and cut.
	std::size_t cellCount() const;
	std::size_t pointCount() const;
	// Of the files: fewer where a reader cut curved cells into linear ones.
	std::size_t sourceCellCount() const;
	std::size_t sourcePointCount() const;
	Box bounds() const;
	// image, rectilinear, curvilinear, unstructured; block-structured for several structured blocks; hybrid for a mix.
	const char* kind() const;
};

/// Whether all blocks know their neighbors.
bool hasNeighbors(const BlockSet& blocks);

/// Whether interfaces have been looked for, or blocks are known to have none. Where not, a mesh finds the few that it
/// needs (mesh/mesh_seams.h).
bool knowsSeams(const BlockSet& blocks);

/// Links the listed grids of a set (unstructured.h), finishes their blocks and matches interfaces, on all cores. Cells
/// and points of these blocks get other ids: nothing that was found before holds any more. Nothing is done where all
/// blocks know their neighbors. Throws as UnstructuredGrid::build().
void buildNeighbors(BlockSet& blocks);

// Throws std::logic_error on a broken invariant: neighbors that do not know each other, ids out of range, boxes that
// do not hold their faces. For tests.
void validate(const Block& block);

} // namespace vp::grid
