#pragma once

#include "base/result.h"
#include "grid/block.h"

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

// Which of the input's times: last, first, the one nearest to a value, or the one of an index that counts from 0.
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

// The number of the chosen one among times, which are ascending; 0 where there are none.
std::size_t timeIndex(const std::vector<double>& times, const TimeChoice& choice);

// "last", "first", a number, or # and an index; a usage error otherwise, which does not name the setting.
Result<TimeChoice> parseTime(const std::string& text);
std::string timeText(const TimeChoice& time); // read again it is the same

inline TimeChoice timeAt(std::size_t index)
{
	return {TimeChoice::Kind::index, 0.0, index};
}

// Which arrays of points and cells are read. The others are named in grid::Block::arrays_left_out.
struct ArrayWish
{
	bool all = true;
	// Where not all: those with one of these names, which may have "point:" or "cell:" in front.
	std::vector<std::string> names{};
	// And the one that is shown where none is named: each block's first point array, or its first cell array where it
	// has no point arrays.
	bool first = false;
};

struct ReadOptions
{
	TimeChoice time;
	std::string solution; // PLOT3D q file, where its name does not follow from the grid's
	// Curved cells are cut into linear ones over their own points; each level halves the edges of those once more.
	int refine = 0;
	double displace = 0.0; // moves the points of Exodus files by their displacements, times this
	bool patches = false;  // reads what the files name of the boundary: OpenFOAM patches, Exodus side sets
	// Without: where all blocks are unstructured they stay listed (grid/unstructured.h), their seams are not matched,
	// and grid::buildNeighbors() is left to the caller. Not where patches are read, whose faces are looked for.
	bool builds_neighbors = true;
	// One cut is all that is made: curvilinear grids are finished for it (see finishBlock), and seams are not matched.
	bool for_one_cut = false;
	std::stop_token stop{}; // asked to stop, reading ends with an error
	ArrayWish arrays{};
	// Finds Block::geometry, which readFields() and readValues() compare: where it is not known, they find that the
	// grids are others.
	bool identifies_geometry = true;
};

constexpr int kMaxRefine = 6;

// Reads every input (a file, or demo:NAME[:N]) into one block set, finished (see finishBlock, matchInterfaces).
// `builds_neighbors` says more. A file is read in a child process (vprobe-read, beside the program or in its libexec
// folder) which hands its arrays over in shared memory; sizes, types, offsets and ids are checked here before anything
// uses them. A file that is missing, empty, truncated, foreign or damaged, or a child that crashes, runs out of memory
// or out of time, is an input error that names the file. Sections "read", "build" and "adjacency" go to the timeline.
Result<grid::BlockSet> readInputs(const std::vector<std::string>& inputs, const ReadOptions& options,
                                  Timeline* timeline);

// grid::buildNeighbors(), as section "adjacency" of the timeline.
void buildNeighbors(grid::BlockSet& set, Timeline* timeline);

// The arrays of each block of a set that readInputs made of the inputs, read once more, at another time say; none where
// the grids are others.
using BlockFields = std::vector<std::vector<grid::Field>>;
Result<std::optional<BlockFields>> readFields(const std::vector<std::string>& inputs, const ReadOptions& options,
                                              const grid::BlockSet& set, Timeline* timeline);

// Reads the inputs once more, at another time say, into a set that readInputs made of them, and takes their values over
// where the grids are the same. False, and the set as it was, where they are not: readInputs builds them anew.
Result<bool> readValues(const std::vector<std::string>& inputs, const ReadOptions& options, grid::BlockSet& set,
                        Timeline* timeline);

// File name endings that can be read, for --help and error messages.
std::string readableEndings();

} // namespace vp::read
