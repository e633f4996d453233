#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "read/raw_layout.h"
#include "read/read_warning.h"
#include "read/tolerance.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace vp
{
class Timeline;
}

namespace vp::read
{

class ReadAhead;
class ReadyReaders;

// A choice among the times of an input: the last, the first, the one nearest to a value, or the one with an index from
// 0.
struct TimeChoice
{
	enum class Kind
	{
		last,
		first,
		value,
		index
	};
	Kind kind = Kind::last;
	double value = 0.0;
	std::size_t index = 0;

	bool operator==(const TimeChoice&) const = default;
};

// Returns the index of the chosen time among ascending times, 0 if there are none.
std::size_t timeIndex(const std::vector<double>& times, const TimeChoice& choice);

// Reads "last", "first", a number, or # and an index. Any other text is a usage error, which does not name the setting.
Result<TimeChoice> parseTime(const std::string& text);
std::string timeText(const TimeChoice& time); // parseTime() returns the same choice again

inline TimeChoice timeAt(std::size_t index)
{
	return {TimeChoice::Kind::index, 0.0, index};
}

// Which arrays of points and cells are read. The others are named in grid::Block::arrays_left_out.
struct ArrayWish
{
	bool all = true;
	// If not all: the arrays with one of these names, which may begin with "point:" or "cell:".
	std::vector<std::string> names{};
	// And the default array: the first point array of each block, or its first cell array if it has no point arrays.
	bool first = false;

	bool operator==(const ArrayWish&) const = default;
};

struct ReadOptions
{
	TimeChoice time;
	std::string solution; // PLOT3D q file, if its name does not follow from that of the grid
	// Curved cells are cut into linear ones over their own points. Each level halves the edges of these once more. A
	// tolerance (isTolerance()) keeps them as they are, and cuts refine them (grid/curved_cells.h).
	double refine = 0.0;
	int level = 0;             // which of several resolutions of an image, 0 the finest; an error if a file has fewer
	double displace = 0.0;     // moves the points by their displacements times this factor
	std::string displace_by{}; // the point array of displacements; if empty, its name tells
	bool patches = false;      // reads named parts of the boundary: OpenFOAM patches, Exodus side sets
	// If false and all blocks are unstructured, they stay listed (grid/unstructured.h), their seams are not matched,
	// and the caller may call grid::buildNeighbors(). It has no effect with patches, which need boundary faces.
	bool builds_neighbors = true;
	// There will be only one cut: curvilinear grids are finished for that (see finishBlock), and seams are not matched.
	// Where others follow after all, the caller calls grid::buildNeighbors().
	bool for_one_cut = false;
	std::stop_token stop{}; // on a stop request, reading ends with an error
	ArrayWish arrays{};
	std::string format{};              // a name in formats(); if empty, the file's contents and name tell
	std::size_t cells_of_part = 0;     // only for convert(): writes a pack with parts of at most so many cells; 0: none
	bool all_times = false;            // only for a pack: writes the values at all times, not only at one
	std::vector<std::string> slices{}; // files that are slices of one volume, whose first one is read; mostly empty
	RawLayout raw{};                   // layout of files that hold nothing but values; they need one
	// The parts of a file to read, as their numbers in PartList with commas between; empty: all. "?" reads none and
	// only lists them.
	std::string parts{};
	// The cells of a pack stay in its file if they lie there unpacked, and are read in runs (grid::Block::runs). Only
	// for one input.
	bool keeps_in_runs = false;
	// Number of slabs into which a lattice is split if it is alone in its file. Each slab is a part. Use the same
	// number to list parts and to read them.
	int slabs = 1;
	// Only for convert(): the file that is written as well, and the folder that it is written into.
	std::string convert_to{};
	std::string convert_folder{};
	// Arrays of images and rectilinear grids of more bytes than this stay in their file where that has them unpacked,
	// and are read part by part where they are cut (grid::Field::stored). Nothing: none do.
	std::optional<std::uint64_t> stays_above{};
	std::string unpack{};              // only for Unpacker: what it unpacks, and nothing else (protocol.h)
	std::vector<std::string> follow{}; // folders with files that the inputs may name, or "anywhere"; see setFollow()
	bool cell_to_point = false;        // arrays of cells become arrays of points (grid/curved/cells_to_points.h)
	// Computes Block::geometry, which readFields() and readValues() compare. Without it they take the grids for
	// different.
	bool identifies_geometry = true;
	// Serves whoever reads several files, or a file several times, and hands the same one on each time. May be null.
	std::shared_ptr<ReadyReaders> ready{};

	bool operator==(const ReadOptions&) const = default;
};

constexpr int kMaxRefine = 6;
constexpr int kMaxLevel = 60; // each has half as many points a side
// Reads all inputs (files, or demo:NAME[:N]) into one block set and finishes it (see finishBlock, matchInterfaces, and
// `builds_neighbors`). A file is read in a child process (vprobe-read, beside the program or in its libexec
// folder) which passes its arrays in shared memory. Sizes, types, offsets and ids are checked here before they
// are used. A file that is missing, empty, truncated, foreign or damaged, or a child that crashes, runs out of memory
// or out of time, is an input error that names the file. Sections "read", "build" and "adjacency" go to the timeline.
Result<grid::BlockSet> readInputs(const std::vector<std::string>& inputs, const ReadOptions& options,
                                  Timeline* timeline);

// A part of the inputs that can be cut on its own: a piece of a parallel file, or a block.
struct Part
{
	std::size_t input = 0;  // which of the inputs
	std::size_t number = 0; // index among the parts of that input
	std::size_t cells = 0;  // about
	std::size_t block = 0;  // its block, if all parts are read at once
};

// The parts of all inputs in their order, and the facts about their blocks.
struct PartList
{
	struct Whole
	{
		std::string kind{};     // empty where each part is a block or several
		std::size_t points = 0; // points of a lattice, whose parts share some; else 0
	};
	std::vector<Part> parts;
	std::vector<Whole> blocks;
	std::vector<double> times;
	std::string time_units{};     // as of grid::BlockSet
	std::uint64_t bytes_read = 0; // for this list
};

// Lists what can be read in parts. Files that name their pieces are not read for that; of others the reader reads all
// and hands nothing over.
Result<PartList> listParts(const std::vector<std::string>& inputs, const ReadOptions& options, Timeline* timeline);

struct InputWarning
{
	std::string input;
	ReadWarning warning;
};

// Reports it as a warning, with the input's name.
void tell(const InputWarning& warning);

// Blocks that were read, and for each of them the part that it is of.
struct PartBlocks
{
	grid::BlockSet set;
	std::vector<Part> of_block;
	std::vector<InputWarning> warnings; // not told yet: another process may read more parts of the same file
	std::uint64_t bytes_read = 0;       // by the readers, from files
};

// Reads some of the parts, as readInputs() does. The blocks of the parts come in the order of the list; a part without
// three-dimensional cells has none.
Result<PartBlocks> readParts(const std::vector<std::string>& inputs, const std::vector<Part>& parts,
                             const ReadOptions& options, Timeline* timeline);

// grid::buildNeighbors(), as section "adjacency" of the timeline.
void buildNeighbors(grid::BlockSet& set, Timeline* timeline, bool for_one_cut = false);

// Reads the arrays again, for example at another time, for the blocks of a set that readInputs() made. Returns nothing
// if the grids differ.
using BlockFields = std::vector<std::vector<grid::Field>>;
Result<std::optional<BlockFields>> readFields(const std::vector<std::string>& inputs, const ReadOptions& options,
                                              const grid::BlockSet& set, Timeline* timeline);

// Reads the inputs again, for example at another time, into a set that readInputs() made from them. If the grids are
// the same, takes over the values. Else returns false and leaves the set as it is; then use readInputs().
Result<bool> readValues(const std::vector<std::string>& inputs, const ReadOptions& options, grid::BlockSet& set,
                        Timeline* timeline);
// The same for the next of the readings ahead, as many as there are inputs. If it returns false, some of them are left.
Result<bool> readValues(ReadAhead& ahead, std::size_t inputs, grid::BlockSet& set, Timeline* timeline);

} // namespace vp::read
