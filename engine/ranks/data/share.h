#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "grid/cell_runs.h"
#include "ranks/ranks.h"
#include "read/read.h"
#include "view/view_spec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace vp
{
class Timeline;
}

namespace vp::ranks
{
/// The share of a data set that a rank of a team holds. Every rank lists the blocks of all ranks in the same order, so
/// that a number means the same block everywhere. If another rank holds a block, the list has only its name, its bounds
/// and the names of its arrays, and no cells.
struct Share
{
	/// Counts of the data set, as one process that reads all of it has them.
	struct Counts
	{
		std::string kind;
		std::size_t cells = 0;
		std::size_t points = 0;
		std::size_t linear_cells = 0;
		std::size_t linear_points = 0;
		std::size_t blocks = 0;
	};
	Counts counts;
	std::size_t own_parts = 0;
	std::uint64_t bytes_read = 0;     // by this rank's readers, from files
	std::uint64_t counted_before = 0; // bytesRead() when they had ended
	std::uint32_t first_own = 0;      // blocks of this rank follow each other
	std::uint32_t end_own = 0;
	bool has_packs = false;           // whose runs the ranks share
	std::vector<std::uint32_t> whole; // per block, the block that one process would have in its place

	bool isOwn(std::size_t block) const { return first_own <= block && block < end_own; }
};

/// Returns an error if several ranks cannot carry out the settings to the same result as one process. It names the
/// remedy.
Status canCarryOut(const Ranks& ranks, const view::ViewSpec& spec);

/// Returns the rank of each part: parts that follow each other, so that the most cells of a rank are as few as can be.
std::vector<int> dealOut(const std::vector<read::Part>& parts, int ranks);

/// Reads the inputs: all of them, or this rank's share, which the ranks know from then on.
Result<grid::BlockSet> readInputs(Ranks& ranks, const std::vector<std::string>& inputs,
                                  const read::ReadOptions& options, Timeline* timeline);

/// Returns the counts of the data set, whoever holds its blocks.
Share::Counts countsOf(const Ranks& ranks, const grid::BlockSet& blocks);

/// Returns true if several processes share a pack by its runs.
inline bool shareAPack(const Ranks& ranks)
{
	return ranks.team() && ranks.share().has_packs;
}

/// Returns how many of a block's cells this process has. Those of a pack may be in the file.
inline std::size_t cellsHere(const grid::Block& block)
{
	return block.runs ? block.runs->ownCells()
	                  : std::visit([](const auto& grid) { return grid.cellCount(); }, block.grid);
}

/// Returns true if this process holds the block.
inline bool isHere(const Ranks& ranks, std::size_t block)
{
	return !ranks.team() || ranks.share().isOwn(block);
}

/// Returns true if all ranks have the values at a time in the files of the blocks that they hold (grid::CellRuns). All
/// ranks get the same.
bool hasTimeInRuns(const Ranks& ranks, const grid::BlockSet& blocks, std::size_t time);

/// Puts the number of the block that one process would have in the place of each number.
void nameWholeBlocks(const Ranks& ranks, std::span<std::int32_t> blocks);

} // namespace vp::ranks
