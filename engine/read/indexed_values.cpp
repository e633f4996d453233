// How values are read out of the file that an index is of (packed_cells.h).
#include "base/bytes_read.h"
#include "parts/stoppable.h"
#include "read/packed_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace vp::read
{

using grid::Association;

void PackedCells::readSourceCells(const Piece& piece) const
{
	auto* numbers = source_cells_->as<std::uint32_t>() + piece.first_cell;
	readRows({contents_.cell_numbers, sizeof(std::uint32_t)}, piece.first_cell, piece.cells, numbers);
	if (*std::max_element(numbers, numbers + piece.cells) >= all_rows_)
		throw parts::Unreadable(
		    fmt::format("{}: truncated or damaged: a cell has a number that is not there", contents_.file->name()));
}

// Reads values out of the file that an index is of. What fails is read again by the next fetch().
void PackedCells::readInPlace(const Missing& missing)
{
	std::vector<std::vector<PagedValues::Extent>> extents;
	std::vector<std::pair<std::size_t, PagedValues::Extent>> wanted; // with the number of the array
	const auto* numbers = isIndex() ? source_cells_->as<std::uint32_t>() : nullptr;
	for (std::size_t a = 0; a < paged_.size(); ++a)
	{
		extents.emplace_back();
		if (!paged_[a])
			continue;
		PagedValues& values = *paged_[a];
		if (contents_.arrays[a].field.association == Association::point)
			for (const std::uint32_t part : missing.parts)
				for (const std::uint32_t point : pointsOf(part))
					values.want(point);
		else
			for (const Piece& piece : missing.pieces)
				for (std::uint64_t c = piece.first_cell; c < piece.first_cell + piece.cells; ++c)
					values.want(numbers[c]);
		extents.back() = values.missing();
		values.announce(extents.back());
		for (const PagedValues::Extent& extent : extents.back())
			wanted.emplace_back(a, extent);
	}
	parts::forEachStoppable(wanted, [this](const auto& each) { paged_[each.first]->read(each.second); });
	for (std::size_t a = 0; a < paged_.size(); ++a)
		if (paged_[a])
			paged_[a]->note(extents[a]);
	std::uint64_t bytes = 0;
	for (const auto& [array, extent] : wanted)
		bytes += extent.second - extent.first;
	bytes_read_ += bytes;
	bytesRead().fetch_add(bytes, std::memory_order_relaxed);
	if (rows_in_place_.cell > 0)
		parts::forEachStoppable(missing.pieces, [this](const Piece& piece) { copyCellValues(piece); });
}

// Brings the values of cells, which were read as the file has them, into the order of the pack.
void PackedCells::copyCellValues(const Piece& piece) const
{
	const auto* numbers = source_cells_->as<std::uint32_t>();
	for (std::size_t a = 0; a < paged_.size(); ++a)
		if (const ArrayLists& array = contents_.arrays[a];
		    array.is_in_source && array.field.association == Association::cell)
			for (std::uint64_t c = piece.first_cell; c < piece.first_cell + piece.cells; ++c)
				std::memcpy(arrays_[a]->data() + c * array.row_bytes, paged_[a]->row(numbers[c]), array.row_bytes);
}

// Pages are known when their rows are. So as many bytes are taken for a row as those that are there took.
std::uint64_t PackedCells::bytesInPlaceAfter(const std::vector<bool>& values) const
{
	constexpr double usual = 4.0;
	double there = 0.0, all = 0.0;
	for (const auto& paged : paged_)
	{
		if (!paged)
			continue;
		there += static_cast<double>(paged->bytesThere());
		all += static_cast<double>(paged->bytes());
	}
	const auto before = static_cast<double>(bytesOf(has_values_.runs, rows_in_place_));
	const double more = static_cast<double>(bytesOf(values, rows_in_place_)) - before;
	return static_cast<std::uint64_t>(std::min(all, there + more * (before > 0.0 ? there / before : usual)));
}

} // namespace vp::read
