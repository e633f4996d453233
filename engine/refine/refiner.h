#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "grid/field_choice.h"
#include "refine/cell_boxes.h"
#include "refine/cell_kinds.h"
#include "refine/sheets.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace vp::refine
{

/// The result of a Refiner for some sheets.
struct Refined
{
	// Blocks of curved cells are listed grids of the linear parts that the sheets meet; the others are as they were.
	// Cell arrays are shared, point arrays interpolated.
	std::shared_ptr<const grid::BlockSet> blocks;
	std::size_t looked_at = 0;  // curved cells whose nodes were looked at
	std::size_t cells = 0;      // curved cells that the sheets may meet, which were refined
	std::size_t parts = 0;      // linear cells in the blocks
	std::size_t unfinished = 0; // curved cells that are shown as far as they were refined
	std::string warning;        // names the first of them, and why
};

/// Refines the curved cells of a block set (grid/curved_cells.h) where sheets meet them. Keeps boxes of cells from call
/// to call. Thread safe.
class Refiner
{
public:
	/// The blocks must outlive it. Looks at nothing.
	explicit Refiner(const grid::BlockSet& blocks);
	~Refiner();

	/// shown: the arrays to whose range the tolerance applies. A usage error where these have too many components, or
	/// where there would be too many parts. A stop request ends it with ErrorKind::cancelled.
	Result<Refined> refine(const Sheets& sheets, std::span<const grid::FieldChoice> shown, const std::stop_token& stop);

	/// Call this if the values of the blocks have changed.
	void forgetValues();

	/// Returns the bytes that are kept.
	std::size_t bytes() const;

private:
	/// The data that is kept for a block.
	struct Known
	{
		explicit Known(const grid::CurvedCells& curved) : kinds(curved), boxes(curved, kinds) {}
		CellKinds kinds;
		CellBoxes boxes;
	};
	const Known& knownOf(std::size_t block);
	double rangeOf(const grid::FieldChoice& choice);

	const grid::BlockSet& blocks_;
	mutable std::mutex mutex_;
	std::vector<std::unique_ptr<Known>> known_;                // per block, when it is first needed
	std::vector<std::pair<grid::FieldChoice, double>> ranges_; // sizes of ranges that were asked for
};

/// Returns true if a block has curved cells.
bool hasCurvedCells(const grid::BlockSet& blocks);

} // namespace vp::refine
