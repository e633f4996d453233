#pragma once

#include "base/vec.h"
#include "parts/part_store.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vp::grid
{

struct ArrayFacts;
struct Block;
struct Field;

/// The cells of a listed grid that stays in its file. They are in runs: cells that follow each other, and lie together
/// in space. A run is read when somebody needs it. A cell has the same id whichever runs were read, and so has a point;
/// cells and points that nobody has read are zero.
class CellRuns
{
public:
	struct Run
	{
		Box box; // around the points of its cells
		std::uint64_t first_cell;
		std::uint32_t cells;
		std::uint32_t part; // Runs of a part share its points.
	};

	virtual ~CellRuns() = default;
	CellRuns(const CellRuns&) = delete;
	CellRuns& operator=(const CellRuns&) = delete;

	/// By ascending cells and parts.
	const std::vector<Run>& runs() const { return runs_; }
	/// Numbers of runs, from `begin` to before `end`.
	struct Range
	{
		std::uint32_t begin = 0;
		std::uint32_t end = 0;
	};
	/// Of several processes that share the file, each has its own runs, and looks at no others.
	const Range& own() const { return own_; }
	bool isShare() const { return own_.end - own_.begin < runs_.size(); }
	/// Returns how many cells its own runs have.
	std::size_t ownCells() const
	{
		const Run& last = runs_[own_.end - 1];
		return last.first_cell + last.cells - runs_[own_.begin].first_cell;
	}
	/// Returns the numbers of the runs that a surface may meet, ascending. Surface: has meets(Box).
	template <class Surface>
	std::vector<std::uint32_t> meeting(const Surface& surface) const
	{
		std::vector<std::uint32_t> met;
		for (std::uint32_t run = own_.begin; run < own_.end; ++run)
			if (surface.meets(runs_[run].box))
				met.push_back(run);
		return met;
	}
	std::vector<std::uint32_t> all() const;
	/// Returns the numbers of the runs, ascending, that have points on both sides of a value, or with that value. All
	/// runs, if the file does not say which values its runs have. field: of points, as the block has it now. component:
	/// 0.. or kMagnitude. Any thread may call it.
	virtual std::vector<std::uint32_t> holding(const Field& field, int component, double value) const = 0;

	/// Returns how many times its file has, at least one. Its cells are the same at all of them.
	virtual std::size_t times() const = 0;
	/// Gives its block the values at a time, of which nothing was read. Copies of the block keep theirs. next: the time
	/// that will probably follow. When the values of this one are there, the system is asked to read ahead.
	virtual void goTo(std::size_t time, std::optional<std::size_t> next, Block& block) = 0;
	/// Returns what the file says of an array's values at a time; null if the file does not have the array.
	virtual std::shared_ptr<const ArrayFacts> factsAt(std::size_t time, const Field& field) const = 0;

	/// Reads those of some runs (ascending) that are not in memory, on all cores. Throws parts::Unreadable, and
	/// parts::Stopped. One thread at a time may call it. Meanwhile others may look at what was read before.
	virtual void fetch(std::span<const std::uint32_t> runs) = 0;
	/// Returns how many bytes of the file would be in memory after that.
	virtual std::uint64_t bytesAfter(std::span<const std::uint32_t> runs) const = 0;
	/// Gives its block runs, points, cells and values anew, of which nothing was read. Copies of the block keep theirs.
	virtual void renew(Block& block) const = 0;
	/// Returns the ids of the points of a part that has a run in memory.
	virtual std::span<const std::uint32_t> pointsOf(std::uint32_t part) const = 0;

	/// Returns what was used since the last call of startCounting(). A run counts as a part.
	virtual parts::PartUse use() const = 0;
	virtual void startCounting() = 0;

protected:
	/// own: at least one of the runs, which are not empty.
	CellRuns(std::vector<Run> runs, Range own) : runs_(std::move(runs)), own_(own) {}

private:
	std::vector<Run> runs_;
	Range own_;
};

} // namespace vp::grid
