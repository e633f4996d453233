// How rows of a pack are read and checked (packed_cells.h).
#include "read/packed_cells.h"

#include "base/bytes_read.h"
#include "parts/stoppable.h"
#include "read/cell_types.h"
#include "read/check_mesh.h"
#include "read/collapsed_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

#include <fcntl.h>

namespace vp::read
{

using grid::Association;

namespace
{

// Writes the numbers of rows to the places of their points. Two parts may write the same point at the same time.
// isThere: whether a point was read before, when others may look at it.
template <class Number, class IsThere>
void scatter(std::span<const std::byte> rows, std::span<const std::uint32_t> points, std::byte* to,
             const IsThere& isThere)
{
	const std::size_t numbers = rows.size() / points.size() / sizeof(Number);
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		if (isThere(points[i]))
			continue;
		auto* row = reinterpret_cast<Number*>(to) + numbers * points[i];
		for (std::size_t n = 0; n < numbers; ++n)
		{
			Number number;
			std::memcpy(&number, rows.data() + (i * numbers + n) * sizeof(Number), sizeof(Number));
			std::atomic_ref(row[n]).store(number, std::memory_order_relaxed);
		}
	}
}

template <class IsThere>
void scatter(std::size_t number_bytes, std::span<const std::byte> rows, std::span<const std::uint32_t> points,
             std::byte* to, const IsThere& isThere)
{
	if (points.empty())
		return;
	number_bytes == 8   ? scatter<std::uint64_t>(rows, points, to, isThere)
	: number_bytes == 4 ? scatter<std::uint32_t>(rows, points, to, isThere)
	: number_bytes == 2 ? scatter<std::uint16_t>(rows, points, to, isThere)
	                    : scatter<std::uint8_t>(rows, points, to, isThere);
}

std::vector<std::byte>& scratchOf(std::size_t bytes)
{
	static thread_local std::vector<std::byte> scratch;
	scratch.resize(bytes);
	return scratch;
}

} // namespace

parts::Unreadable PackedCells::damaged(const char* reason) const
{
	return parts::Unreadable(fmt::format("{}: truncated or damaged: {}", contents_.file->name(), reason));
}

void PackedCells::fetch(std::span<const std::uint32_t> runs)
{
	for (const std::uint32_t run : runs)
		met_[run] = true;
	const Missing cells = missing(runs, has_cells_), values = missing(runs, has_values_);
	if (!values.runs.empty())
	{
		Extents extents;
		addCells(cells, extents);
		addValues(values, contents_.time, extents);
		contents_.file->announce(std::move(extents));
		readCells(cells);
		readValues(values);
		read_ += values.runs.size();
	}
	checkRanges(runs);
	announceNextTime();
}

void PackedCells::readCells(const Missing& missing)
{
	parts::forEachStoppable(missing.parts, [this](std::uint32_t part) { readPoints(part); });
	parts::forEachStoppable(missing.pieces, [this](const Piece& piece) { readPiece(piece); });
	for (const std::uint32_t part : missing.parts)
		notePoints(part, has_point_);
	note(missing, rows_of_cells_, has_cells_);
}

void PackedCells::readValues(const Missing& missing)
{
	if (rows_of_values_.point > 0)
		parts::forEachStoppable(missing.parts, [this](std::uint32_t part) { readPointValues(part); });
	if (rows_of_values_.cell > 0)
		parts::forEachStoppable(missing.pieces, [this](const Piece& piece) { readCellValues(piece); });
	readInPlace(missing);
	for (const std::uint32_t part : missing.parts)
		notePoints(part, has_values_of_);
	note(missing, rows_of_values_, has_values_);
}

void PackedCells::note(const Missing& read, const RowBytes& rows, Kept& kept)
{
	std::uint64_t bytes = 0;
	for (const std::uint32_t part : read.parts)
	{
		kept.parts[part] = true;
		bytes += bytesOfPart(part, rows);
	}
	for (const std::uint32_t run : read.runs)
	{
		kept.runs[run] = true;
		bytes += bytesOfRun(run, rows);
	}
	bytes_read_ += bytes;
	bytesRead().fetch_add(bytes, std::memory_order_relaxed);
}

std::vector<PackedCells::Piece> PackedCells::piecesOf(std::span<const std::uint32_t> numbers) const
{
	std::vector<Piece> pieces;
	for (const std::uint32_t number : numbers)
	{
		const Run& run = runs()[number];
		const bool goes_on = !pieces.empty() && pieces.back().first_run + pieces.back().runs == number &&
		                     runs()[number - 1].part == run.part;
		if (!goes_on)
			pieces.push_back({.first_run = number, .first_cell = run.first_cell, .first_id = first_ids_[number]});
		Piece& piece = pieces.back();
		++piece.runs;
		piece.cells += run.cells;
		piece.ids += contents_.run_ids[number];
	}
	return pieces;
}

namespace
{

void addRows(const PackedCells::List& list, std::uint64_t first, std::uint64_t count,
             std::vector<std::pair<std::uint64_t, std::uint64_t>>& to)
{
	to.emplace_back(list.offset + first * list.row_bytes, list.offset + (first + count) * list.row_bytes);
}

} // namespace

void PackedCells::addCells(const Missing& missing, Extents& to) const
{
	for (const std::uint32_t number : missing.parts)
	{
		const Part& part = parts_[number];
		addRows(contents_.places, part.first_point, part.points, to);
		addRows(contents_.point_numbers, part.first_point, part.points, to);
	}
	for (const Piece& piece : missing.pieces)
	{
		addRows(contents_.ids, piece.first_id, piece.ids, to);
		if (isIndex())
			addRows({contents_.cell_numbers, sizeof(std::uint32_t)}, piece.first_cell, piece.cells, to);
		if (!hasFaces())
			continue;
		const std::uint32_t run = piece.first_run, end = piece.first_run + piece.runs;
		const FirstFace &first = first_faces_[run], &behind = first_faces_[end];
		addRows(contents_.face_ids, first.id, behind.id - first.id, to);
		addRows(contents_.face_ends, firstFaceEndOf(run), behind.face - first.face + 1, to);
		addRows(contents_.polyhedron_ends, firstEndOf(run), piece.cells + 1, to);
	}
}

void PackedCells::addValues(const Missing& missing, std::size_t time, Extents& to) const
{
	for (const ArrayLists& array : contents_.arrays)
		if (array.is_in_source)
			continue; // pages are known when their rows are
		else if (array.field.association == Association::point)
			for (const std::uint32_t part : missing.parts)
				addRows(array.at(time), parts_[part].first_point, parts_[part].points, to);
		else
			for (const Piece& piece : missing.pieces)
				addRows(array.at(time), piece.first_cell, piece.cells, to);
}

// The next time is mostly cut where this one was.
void PackedCells::announceNextTime()
{
	if (!next_time_)
		return;
	std::vector<std::uint32_t> met;
	for (std::uint32_t run = 0; run < met_.size(); ++run)
		if (met_[run])
			met.push_back(run);
	Extents extents;
	addValues(missing(met, nothing()), *next_time_, extents);
	contents_.file->announce(std::move(extents));
	for (std::size_t a = 0; a < paged_.size(); ++a)
		if (paged_[a])
			paged_[a]->announce(paged_[a]->wanted(), contents_.arrays[a].at(*next_time_).offset);
	next_time_.reset();
}

void PackedCells::readRows(const List& list, std::uint64_t first, std::uint64_t count, void* to) const
{
	contents_.file->read(list.offset + first * list.row_bytes,
	                     {static_cast<std::byte*>(to), static_cast<std::size_t>(count * list.row_bytes)});
}

void PackedCells::readPoints(std::uint32_t number) const
{
	const Part& part = parts_[number];
	readRows(contents_.point_numbers, part.first_point, part.points,
	         point_numbers_->as<std::uint32_t>() + part.first_point);
	const std::span<const std::uint32_t> points = pointsOf(number);
	for (std::size_t p = 0; p < points.size(); ++p)
		if (points[p] >= contents_.all_points || (p > 0 && points[p] <= points[p - 1]))
			throw damaged("the points of a part are out of order");
	takePoints(contents_.places, contents_.places.row_bytes / 3, number, has_point_, places_);
}

void PackedCells::readPointValues(std::uint32_t part) const
{
	for (std::size_t a = 0; a < arrays_.size(); ++a)
		if (const ArrayLists& array = contents_.arrays[a];
		    !array.is_in_source && array.field.association == Association::point)
			takePoints(array.at(contents_.time), grid::byteSize(array.field.type), part, has_values_of_, arrays_[a]);
}

// there: the bits of points that earlier fetches have read.
void PackedCells::takePoints(const List& list, std::size_t number_bytes, std::uint32_t part, const Memory& there,
                             const Memory& to) const
{
	const auto isThere = [bits = there->as<std::uint64_t>()](std::uint32_t point)
	{ return (bits[point / 64] >> point % 64 & 1) != 0; };
	std::vector<std::byte>& rows = scratchOf(parts_[part].points * list.row_bytes);
	readRows(list, parts_[part].first_point, parts_[part].points, rows.data());
	scatter(number_bytes, rows, pointsOf(part), to->data(), isThere);
}

void PackedCells::notePoints(std::uint32_t part, const Memory& there) const
{
	auto* bits = there->as<std::uint64_t>();
	for (const std::uint32_t point : pointsOf(part))
		bits[point / 64] |= std::uint64_t(1) << point % 64;
}

void PackedCells::readCellValues(const Piece& piece) const
{
	for (std::size_t a = 0; a < arrays_.size(); ++a)
		if (const ArrayLists& array = contents_.arrays[a];
		    !array.is_in_source && array.field.association == Association::cell)
			readRows(array.at(contents_.time), piece.first_cell, piece.cells,
			         arrays_[a]->data() + piece.first_cell * array.row_bytes);
}

void PackedCells::readPiece(const Piece& piece) const
{
	readRows(contents_.ids, piece.first_id, piece.ids, id_memory_->as<std::int32_t>() + piece.first_id);
	if (isIndex())
		readSourceCells(piece);
	takeTypes(piece);
	for (std::uint32_t run = piece.first_run; run < piece.first_run + piece.runs; ++run)
	{
		takeIds(run, {id_memory_->as<std::int32_t>() + first_ids_[run], contents_.run_ids[run]});
		if (hasFaces())
			takeFaces(run);
	}
	if (contents_.type != kTetra)
		orderCollapsed(cells(), piece.first_cell, piece.first_cell + piece.cells,
		               {id_memory_->as<std::int32_t>(), ids_});
}

// Where the ends of a run's cells begin, with that of the cell before.
std::uint64_t PackedCells::firstEndOf(std::uint32_t number) const
{
	const Run& run = runs()[number];
	return contents_.first_ends[run.part] + (run.first_cell - parts_[run.part].first_cell);
}

void PackedCells::takeTypes(const Piece& piece) const
{
	auto* types = types_->as<std::uint8_t>() + piece.first_cell;
	if (isAlike())
	{
		std::atomic_ref(types[0]).store(contents_.type, std::memory_order_relaxed); // the first cell has its type
		std::fill_n(types + 1, piece.cells - 1, contents_.type);
		return;
	}
	readRows(contents_.types, piece.first_cell, piece.cells, types);
	std::vector<std::int32_t> ends(piece.cells + 1);
	readRows(contents_.ends, firstEndOf(piece.first_run), ends.size(), ends.data());
	auto* starts = ends_->as<std::int64_t>() + piece.first_cell;
	std::uint64_t sum = 0;
	for (std::size_t c = 0; c < piece.cells; ++c)
	{
		const auto size = static_cast<std::int64_t>(ends[c + 1]) - ends[c];
		const bool is_polyhedron = types[c] == kPolyhedron && hasFaces() && size >= 0;
		if (!is_polyhedron && (slicedCellSize(types[c]) == 0 || size != slicedCellSize(types[c])))
			throw damaged("a cell has not as many points as its type");
		std::atomic_ref(starts[c]).store(static_cast<std::int64_t>(piece.first_id + sum), std::memory_order_relaxed);
		sum += static_cast<std::uint64_t>(size);
	}
	if (sum != piece.ids)
		throw damaged("the Offsets of a part do not match it");
	// The piece behind it may write the same.
	std::atomic_ref(starts[piece.cells])
	    .store(static_cast<std::int64_t>(piece.first_id + sum), std::memory_order_relaxed);
}

namespace
{

// A cut goes by the boxes, so points that were moved by hand would lose cells without a word. All three numbers of a
// point are compared at once, and one of the next point, which tells nothing.
template <class Number>
bool liesOutside(std::span<const std::int32_t> ids, const Number* places, const Box& box)
{
	using Four [[gnu::vector_size(4 * sizeof(Number))]] = Number;
	using Mask = decltype(Four{} <= Four{});
	// A float is within bounds of double precision exactly if it is within those that are rounded inwards.
	const auto inward = [](double bound, double towards)
	{
		auto rounded = static_cast<Number>(bound);
		if ((towards > 0.0) ? rounded < bound : rounded > bound)
			rounded = std::nextafter(rounded, static_cast<Number>(towards));
		return rounded;
	};
	constexpr double infinity = std::numeric_limits<double>::infinity();
	const Four lo{inward(box.lo.x, infinity), inward(box.lo.y, infinity), inward(box.lo.z, infinity)};
	const Four hi{inward(box.hi.x, -infinity), inward(box.hi.y, -infinity), inward(box.hi.z, -infinity)};
	Mask inside = ~Mask{};
	for (const std::int32_t id : ids)
	{
		Four at;
		std::memcpy(&at, places + 3 * static_cast<std::size_t>(id), sizeof(at));
		inside &= (at >= lo) & (at <= hi);
	}
	return !(inside[0] && inside[1] && inside[2]);
}

} // namespace

// Turns ids of a run into those of the whole.
void PackedCells::takeIds(std::uint32_t number, std::span<std::int32_t> ids) const
{
	const Run& run = runs()[number];
	const std::span<const std::uint32_t> points = pointsOf(run.part);
	const auto first = static_cast<std::uint32_t>(contents_.first_ids[run.part]);
	std::uint32_t largest = 0; // an id below the first becomes a large number
	for (const std::int32_t id : ids)
		largest = std::max(largest, static_cast<std::uint32_t>(id) - first);
	if (largest >= points.size() && !ids.empty())
		throw damaged("a cell has a point that is not there");
	for (std::int32_t& id : ids)
		id = static_cast<std::int32_t>(points[static_cast<std::uint32_t>(id) - first]);
	if (contents_.places.row_bytes == 3 * sizeof(double) ? liesOutside(ids, places_->as<double>(), run.box)
	                                                     : liesOutside(ids, places_->as<float>(), run.box))
		throw damaged("a point lies outside the box of its cells; pack or index the file again");
}

} // namespace vp::read
