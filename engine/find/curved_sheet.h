#pragma once

#include "grid/block.h"
#include "grid/cell_filter.h"
#include "grid/field_choice.h"
#include "probe/sheet.h"
#include "surface/curved.h"
#include "surface/leaf_values.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace vp::find
{

// Keeps the ranges of an array in the leaves of the block trees from cut to cut, for the last array of each block.
// Thread safe.
class ValueRanges
{
public:
	explicit ValueRanges(std::size_t blocks) : kept_(blocks) {}

	std::shared_ptr<const surface::LeafValues> of(std::size_t number, const grid::Block& block,
	                                              const grid::Field& field, int component);
	void forget(); // call this when the values of the arrays change
	std::size_t bytes() const;

private:
	struct Kept
	{
		const void* values = nullptr;
		int component = 0;
		std::shared_ptr<const surface::LeafValues> ranges;
	};
	mutable std::mutex mutex_;
	std::vector<Kept> kept_;
};

// The form of a placed sheet, which has one, as each block sees it. field: the shown array; an iso value is of it, and
// blocks that lack it, or have it on cells, are cut nowhere. ranges: null where nothing is to be looked for.
std::vector<surface::BlockSurface> surfacesOf(const grid::BlockSet& blocks, const probe::Sheet& sheet,
                                              const std::optional<grid::FieldChoice>& field,
                                              ValueRanges* ranges = nullptr);

// The surfaces of one value of an array: as surfacesOf() has them for an iso value.
std::vector<surface::BlockSurface> isoSurfaces(const grid::BlockSet& blocks, double value,
                                               const std::optional<grid::FieldChoice>& field,
                                               ValueRanges* ranges = nullptr);

// Returns a filter that rejects cells with a NaN or infinite value. It is empty if there are no such values, or if the
// surface does not depend on values.
grid::CellFilter finiteCells(const grid::Block& block, const surface::BlockSurface& surface);

} // namespace vp::find
