#include "read/packed_cells.h"

#include "grid/block.h"
#include "read/cell_types.h"
#include "read/check_mesh.h"
#include "read/run_ranges.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace vp::read
{

using grid::Association;

namespace
{

constexpr std::uint64_t kMaxRows = std::uint64_t(1) << 40;
constexpr std::uint64_t kMaxOfRun = std::numeric_limits<std::uint32_t>::max();

std::uint64_t sumOf(std::span<const std::uint64_t> counts, std::uint64_t most)
{
	std::uint64_t sum = 0;
	for (const std::uint64_t count : counts)
		if (count > most || (sum += count) > kMaxRows)
			throw Unusable("its runs have more cells or points than there can be");
	return sum;
}

void refuseOutside(const parts::OpenFile& file, const PackedCells::List& list, std::uint64_t rows)
{
	if (list.row_bytes == 0 || list.offset > file.size() || rows > (file.size() - list.offset) / list.row_bytes)
		throw Unusable("a list of its parts lies outside of the file");
}

std::shared_ptr<SparseMemory> memoryFor(std::uint64_t rows, std::size_t row_bytes)
{
	return std::make_shared<SparseMemory>(rows * row_bytes);
}

grid::CellRuns::Range ownOf(const PackedCells::Contents& contents)
{
	const auto all = static_cast<std::uint32_t>(contents.runs.size());
	const grid::CellRuns::Range own = contents.own.value_or(grid::CellRuns::Range{0, all});
	if (own.begin >= own.end || own.end > all)
		throw Unusable("the runs of its cells are not there");
	return own;
}

template <class T>
Array<T> viewOf(const std::shared_ptr<SparseMemory>& memory, std::size_t count)
{
	return {memory, memory->template as<const T>(), count};
}

} // namespace

PackedCells::PackedCells(Contents contents)
    : CellRuns(contents.runs, ownOf(contents)), contents_(std::move(contents)), has_cells_(nothing()),
      has_values_(nothing()), met_(runs().size())
{
	contents_.runs = {}; // runs() has them
	check();
	takeMemory();
	takeMemoryOfValues();
}

void PackedCells::check()
{
	const std::size_t parts = contents_.points.size();
	const auto size = static_cast<std::uint64_t>(slicedCellSize(contents_.type));
	if (runs().empty() || contents_.run_ids.size() != runs().size() || contents_.all_cells.size() != parts ||
	    contents_.first_ids.size() != parts || contents_.first_ends.size() != parts || contents_.all_points == 0 ||
	    contents_.all_points > std::numeric_limits<std::int32_t>::max() || (isAlike() && size == 0))
		throw Unusable("the lists of its parts do not match");
	const std::uint64_t points = sumOf(contents_.points, kMaxOfRun);
	const std::uint64_t rows = all_rows_ = sumOf(contents_.all_cells, kMaxRows);
	ids_ = sumOf(contents_.run_ids, kMaxOfRun);
	std::uint64_t first_point = 0, first_cell = 0;
	for (std::size_t p = 0; p < parts; ++p)
	{
		if (contents_.first_ids[p] > kMaxOfRun || contents_.first_ends[p] > kMaxRows)
			throw Unusable("a part has ids that cannot be");
		parts_.push_back({first_point, contents_.points[p], first_cell});
		first_point += contents_.points[p];
		first_cell += contents_.all_cells[p];
	}
	std::uint32_t last_part = 0;
	std::uint64_t first_id = 0;
	for (std::size_t r = 0; r < runs().size(); ++r)
	{
		const Run& run = runs()[r];
		const bool has_part = run.part < parts && run.part >= last_part;
		if (!has_part || run.cells == 0 || run.first_cell != cells_ || run.box.empty() ||
		    !isPlace(run.box.diagonal()) || run.first_cell < parts_[run.part].first_cell ||
		    run.first_cell + run.cells > parts_[run.part].first_cell + contents_.all_cells[run.part] ||
		    (isAlike() && contents_.run_ids[r] != size * run.cells))
			throw Unusable("the runs of its cells do not match its parts");
		last_part = run.part;
		cells_ += run.cells;
		first_ids_.push_back(first_id);
		first_id += contents_.run_ids[r];
	}
	if (cells_ >= kMaxBlockIds)
		throw Unusable("a block of so many cells cannot be held");
	const auto fit = [&](const List& list, std::uint64_t count) { refuseOutside(*contents_.file, list, count); };
	fit(contents_.places, points);
	fit(contents_.point_numbers, points);
	fit(contents_.ids, ids_);
	fit({contents_.cell_numbers, sizeof(std::uint32_t)}, rows);
	std::uint64_t ends = 0;
	for (std::size_t p = 0; p < parts; ++p)
		ends = std::max(ends, contents_.first_ends[p] + contents_.all_cells[p] + 1);
	if (!isAlike())
	{
		fit(contents_.types, rows);
		fit(contents_.ends, ends);
	}
	if (hasFaces())
		checkFaces(ends);
	rows_of_cells_ = {contents_.places.row_bytes + contents_.point_numbers.row_bytes,
	                  (isAlike() ? 0 : contents_.types.row_bytes + contents_.ends.row_bytes) +
	                      (isIndex() ? sizeof(std::uint32_t) : 0) + contents_.polyhedron_ends.row_bytes,
	                  contents_.ids.row_bytes, contents_.face_ends.row_bytes, contents_.face_ids.row_bytes};
	for (const ArrayLists& array : contents_.arrays)
	{
		if (array.times.size() != times() || contents_.time >= times())
			throw Unusable("an array has not values at each time");
		if (array.is_in_source && !isIndex())
			throw Unusable("an array lies in another file, and the file is no index");
		const bool is_of_points = array.field.association == Association::point;
		for (std::size_t time = 0; time < times(); ++time)
		{
			if (array.is_in_source)
				refuseOutside(*contents_.source, array.at(time), is_of_points ? contents_.all_points : rows);
			else
				fit(array.at(time), is_of_points ? points : rows);
			if (const auto ranges = array.times[time].ranges)
				fit({*ranges, bytesOfRanges(array.field)}, runs().size());
		}
		RowBytes& bytes = array.is_in_source ? rows_in_place_ : rows_of_values_;
		(is_of_points ? bytes.point : bytes.cell) += array.row_bytes;
	}
}

// ends: of cells, as the file lists them.
void PackedCells::checkFaces(std::uint64_t ends)
{
	const std::vector<std::uint64_t>&faces = contents_.run_faces, &ids = contents_.run_face_ids;
	if (faces.size() != runs().size() || ids.size() != runs().size() || isAlike())
		throw Unusable("the lists of its polyhedra do not match");
	sumOf(faces, kMaxOfRun); // which refuses what is too much
	const std::uint64_t all_ids = sumOf(ids, kMaxOfRun);
	FirstFace next;
	for (std::size_t r = 0; r < runs().size(); ++r)
	{
		first_faces_.push_back(next);
		next.face += faces[r];
		next.id += ids[r];
		next.in_memory += runs()[r].cells + faces[r] + ids[r];
	}
	first_faces_.push_back(next);
	refuseOutside(*contents_.file, contents_.face_ids, all_ids);
	for (std::uint32_t r = 0; r < runs().size(); ++r)
		refuseOutside(*contents_.file, contents_.face_ends, firstFaceEndOf(r) + faces[r] + 1);
	refuseOutside(*contents_.file, contents_.polyhedron_ends, ends);
}

void PackedCells::takeMemory()
{
	const std::uint64_t points = contents_.all_points;
	places_ = memoryFor(points + 1, contents_.places.row_bytes); // one more, so that a point may be read with the next
	has_point_ = memoryFor(points / 64 + 1, sizeof(std::uint64_t));
	point_numbers_ = memoryFor(parts_.back().first_point + parts_.back().points, sizeof(std::uint32_t));
	id_memory_ = memoryFor(ids_, sizeof(std::int32_t));
	types_ = memoryFor(cells_, 1);
	ends_ = memoryFor(isAlike() ? 0 : cells_ + 1, sizeof(std::int64_t));
	if (isIndex())
		source_cells_ = memoryFor(cells_, sizeof(std::uint32_t));
	if (hasFaces())
	{
		first_of_faces_ = memoryFor(cells_ + 1, sizeof(std::int64_t));
		face_stream_ = memoryFor(first_faces_.back().in_memory, sizeof(std::int64_t));
	}
	types_->data()[0] = std::byte{contents_.type}; // the first tells of all, where they are alike
}

void PackedCells::takeMemoryOfValues()
{
	has_values_of_ = memoryFor(contents_.all_points / 64 + 1, sizeof(std::uint64_t));
	arrays_.clear();
	paged_.clear();
	for (const ArrayLists& array : contents_.arrays)
	{
		const bool is_of_points = array.field.association == Association::point;
		paged_.emplace_back();
		if (array.is_in_source)
			paged_.back() = std::make_unique<PagedValues>(
			    contents_.source,
			    PagedValues::Place{array.at(contents_.time).offset, is_of_points ? contents_.all_points : all_rows_,
			                       array.row_bytes, array.swaps ? grid::byteSize(array.field.type) : 1});
		// Points are numbered as in the file that an index is of, and cells are not.
		arrays_.push_back(array.is_in_source && is_of_points
		                      ? paged_.back()->memory()
		                      : memoryFor(is_of_points ? contents_.all_points : cells_, array.row_bytes));
	}
}

std::size_t PackedCells::times() const
{
	return contents_.arrays.empty() ? 1 : contents_.arrays[0].times.size();
}

void PackedCells::goTo(std::size_t time, std::optional<std::size_t> next, grid::Block& block)
{
	contents_.time = time;
	next_time_ = next;
	has_values_ = nothing();
	ranges_.clear();
	takeMemoryOfValues();
	grid::replaceFields(block, fields());
}

std::shared_ptr<const grid::ArrayFacts> PackedCells::factsAt(std::size_t time, const grid::Field& field) const
{
	const auto found = std::ranges::find_if(
	    contents_.arrays, [&field](const ArrayLists& array)
	    { return array.field.name == field.name && array.field.association == field.association; });
	return found == contents_.arrays.end() ? nullptr : found->times[time].facts;
}

grid::Points PackedCells::points() const
{
	const std::size_t numbers = 3 * contents_.all_points;
	return contents_.places.row_bytes == 3 * sizeof(double) ? grid::Points(viewOf<double>(places_, numbers))
	                                                        : grid::Points(viewOf<float>(places_, numbers));
}

grid::CellList PackedCells::cells() const
{
	grid::CellList list;
	list.types = viewOf<std::uint8_t>(types_, cells_);
	if (!isAlike())
		list.offsets = viewOf<std::int64_t>(ends_, cells_ + 1);
	list.connectivity = viewOf<std::int32_t>(id_memory_, ids_);
	if (hasFaces())
	{
		list.face_offsets = viewOf<std::int64_t>(first_of_faces_, cells_ + 1);
		list.face_stream = viewOf<std::int64_t>(face_stream_, first_faces_.back().in_memory);
	}
	return list;
}

grid::Field PackedCells::cellNumbers() const
{
	constexpr std::uint64_t at_once = 4096;
	const parts::Layout layout{{1, cells_, 1}, {1, at_once, 1}, sizeof(std::uint32_t), false};
	parts::FileExtents::Place place{.offset = contents_.cell_numbers, .number_bytes = sizeof(std::uint32_t)};
	grid::Field numbers;
	numbers.association = Association::cell;
	numbers.type = grid::NumberType::uint32;
	numbers.stored = std::make_shared<parts::PartStore>(
	    layout, std::make_unique<parts::FileExtents>(contents_.file, layout, std::move(place)));
	return numbers;
}

std::vector<grid::Field> PackedCells::fields() const
{
	std::vector<grid::Field> fields;
	for (std::size_t a = 0; a < arrays_.size(); ++a)
	{
		fields.push_back(contents_.arrays[a].field);
		fields.back().facts = contents_.arrays[a].times[contents_.time].facts;
		fields.back().bytes = viewOf<std::byte>(arrays_[a], arrays_[a]->size());
		fields.back().is_in_runs = true;
	}
	return fields;
}

std::span<const std::uint32_t> PackedCells::pointsOf(std::uint32_t part) const
{
	return {point_numbers_->as<std::uint32_t>() + parts_[part].first_point, parts_[part].points};
}

PackedCells::Missing PackedCells::missing(std::span<const std::uint32_t> runs, const Kept& kept) const
{
	Missing missing;
	for (const std::uint32_t run : runs)
	{
		if (kept.runs[run])
			continue;
		missing.runs.push_back(run);
		if (const std::uint32_t part = this->runs()[run].part;
		    !kept.parts[part] && (missing.parts.empty() || missing.parts.back() != part))
			missing.parts.push_back(part);
	}
	missing.pieces = piecesOf(missing.runs);
	return missing;
}

std::uint64_t PackedCells::bytesOfPart(std::uint32_t part, const RowBytes& rows) const
{
	return parts_[part].points * rows.point;
}

std::uint64_t PackedCells::bytesOfRun(std::uint32_t run, const RowBytes& rows) const
{
	const std::uint64_t of_faces =
	    hasFaces() ? contents_.run_faces[run] * rows.face + contents_.run_face_ids[run] * rows.face_id : 0;
	return contents_.run_ids[run] * rows.id + runs()[run].cells * rows.cell + of_faces;
}

std::uint64_t PackedCells::bytesOf(const std::vector<bool>& has, const RowBytes& rows) const
{
	std::uint64_t bytes = 0;
	std::uint32_t last_part = std::numeric_limits<std::uint32_t>::max();
	for (std::uint32_t run = 0; run < has.size(); ++run)
		if (has[run])
		{
			bytes += bytesOfRun(run, rows);
			if (std::exchange(last_part, runs()[run].part) != runs()[run].part)
				bytes += bytesOfPart(runs()[run].part, rows);
		}
	return bytes;
}

std::uint64_t PackedCells::bytesAfter(std::span<const std::uint32_t> runs) const
{
	std::vector<bool> cells = has_cells_.runs, values = has_values_.runs;
	for (const std::uint32_t run : runs)
		cells[run] = values[run] = true;
	return bytesOf(cells, rows_of_cells_) + bytesOf(values, rows_of_values_) + bytesInPlaceAfter(values);
}

void PackedCells::renew(grid::Block& block) const
{
	Contents contents = contents_;
	contents.runs = runs();
	const auto fresh = std::make_shared<PackedCells>(std::move(contents));
	block.grid = grid::UnstructuredGrid::listedInRuns(fresh->points(), fresh->cells());
	for (grid::Field& own : fresh->fields())
		for (grid::Field& field : block.fields)
			if (field.is_in_runs && field.name == own.name && field.association == own.association)
				field.bytes = own.bytes;
	block.runs = fresh;
}

parts::PartUse PackedCells::use() const
{
	return {.all = own().end - own().begin,
	        .kept = static_cast<std::uint64_t>(std::ranges::count(has_cells_.runs, true)),
	        .met = static_cast<std::uint64_t>(std::ranges::count(met_, true)),
	        .read = read_,
	        .bytes_met = bytesOf(met_, rows_of_cells_) + bytesOf(met_, rows_of_values_) + bytesOf(met_, rows_in_place_),
	        .bytes_read = bytes_read_};
}

void PackedCells::startCounting()
{
	met_.assign(met_.size(), false);
	read_ = bytes_read_ = 0;
}

} // namespace vp::read
