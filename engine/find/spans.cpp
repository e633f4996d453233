#include "find/spans.h"

#include "find/flood_sharing.h"
#include "find/row_nibbles.h"
#include "find/row_signs.h"
#include "find/row_window.h"
#include "find/short_run.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <vector>

namespace vp::find
{

namespace
{

using cases::Column;
using cases::LatticeCase;

// A cut cell of a row.
struct Entry
{
	std::uint32_t row;
	std::uint16_t cell;
};

// Cut cells [begin, end) of the row (j, k).
struct Run
{
	std::uint32_t row;
	std::uint32_t j;
	std::uint32_t k;
	std::uint32_t begin;
	std::uint32_t end;
};

template <class Signs, class Extent>
class Flooder
{
public:
	Flooder(const grid::Lattice& lattice, const Signs& signs, const Extent& extent, SpanStore& store)
	    : signs_(signs), extent_(extent), store_(store),
	      thread_(static_cast<std::size_t>(tbb::this_task_arena::current_thread_index())), points_(lattice.points()),
	      cells_(lattice.cells()), columns_(points_[0] + 16)
	{
	}

	// Follows the run of the entry's cell to both ends, and queues the runs beside it.
	void follow(std::vector<Entry>& queue, const Entry entry)
	{
		if (const std::optional<Run> run = findRun(entry))
		{
			extent_.leaveOut(run->row, run->begin, run->end, columns_);
			if (!Extent::kLimits && run->end - run->begin <= ShortRun::kMaxCells)
				takeShort(*run, queue);
			else
			{
				add(*run);
				enterNeighbors(*run, queue);
			}
			if constexpr (Extent::kLimits)
				enterOwners(*run, queue);
		}
	}

private:
	// Computes the four columns from 4 * quad on. Returns a bit for each that is uniform.
	unsigned takeColumns(std::uint32_t quad, PointId row_start)
	{
		const std::uint32_t at = 4 * quad;
		const PointId p = row_start + at;
		const PointId layer = points_[0] * points_[1];
		const std::array<PointId, 4> rows = {p, p + points_[0], p + layer, p + layer + points_[0]};
		const unsigned count = std::min(4u, points_[0] - at);
		std::array<unsigned, 4> bits;
		if (count == 4)
			bits = signs_.sixteen(rows);
		else
			for (std::size_t r = 0; r < rows.size(); ++r)
				bits[r] = signs_.few(rows[r], count);
		const std::uint32_t columns = kNibbleBytes[bits[0]] | kNibbleBytes[bits[1]] << 1 | kNibbleBytes[bits[2]] << 2 |
		                              kNibbleBytes[bits[3]] << 3;
		const unsigned any = bits[0] | bits[1] | bits[2] | bits[3];
		const unsigned all = bits[0] & bits[1] & bits[2] & bits[3];
		std::memcpy(&columns_[at], &columns, 4);
		return ~(any & ~all) & ((1u << count) - 1);
	}

	// Returns the run of an entry, nothing if it is known already or a seed is not cut.
	std::optional<Run> findRun(const Entry& entry)
	{
		if (store_.covers(entry.row, entry.cell))
			return std::nullopt;
		const std::uint32_t k = entry.row / points_[1];
		const PointId row_start = entry.row * points_[0];
		const std::uint32_t quad = entry.cell / 4u;
		const unsigned uniform = takeColumns(quad, row_start);
		const unsigned up_to_cell = (2u << entry.cell % 4u) - 1;
		const Run run{entry.row, entry.row - k * points_[1], k, lastUniform(quad, uniform & up_to_cell, row_start),
		              firstUniform(quad, uniform & ~up_to_cell, row_start)};
		if (run.end == run.begin + 1 && columns_[run.begin] == columns_[run.end] &&
		    cases::isUniform(columns_[run.begin]))
			return std::nullopt;
		return run;
	}
	// Returns the last uniform column up to a quad, 0 if there is none. `uniform` says which columns of the quad are
	// candidates.
	std::uint32_t lastUniform(std::uint32_t quad, unsigned uniform, PointId row_start)
	{
		for (; !uniform; uniform = takeColumns(--quad, row_start))
			if (quad == 0)
				return 0;
		return 4 * quad + static_cast<std::uint32_t>(std::bit_width(uniform)) - 1;
	}
	// Returns the first uniform column from a quad on, the last column of the row if there is none.
	std::uint32_t firstUniform(std::uint32_t quad, unsigned uniform, PointId row_start)
	{
		for (; !uniform; uniform = takeColumns(++quad, row_start))
			if (4 * (quad + 1) >= points_[0])
				return cells_[0];
		return 4 * quad + static_cast<std::uint32_t>(std::countr_zero(uniform));
	}

	void add(const Run& run)
	{
		Span span{run.row, run.begin, run.end, 0, {}};
		SpanCells cells{run.end - run.begin, 0, 0};
		for (std::uint32_t i = run.begin; i < run.end; ++i)
		{
			const LatticeCase& entry = caseAt(i);
			span.counts.vertices += entry.owned_count;
			if (isLeftOut(i))
				continue;
			++cells.cut;
			span.counts.polygons += entry.edges != 0;
			span.counts.corners += entry.edges;
			cells.walked += entry.needs_walk;
		}
		span.counts.vertices += table_[cases::caseIndex(columns_[run.end], columns_[run.end])].owned_count;
		insert(run, span, cells);
	}

	// Does add() and enterNeighbors() for a short run without cells that are left out.
	void takeShort(const Run& run, std::vector<Entry>& queue)
	{
		const std::uint32_t length = run.end - run.begin;
		const ShortRun bits(&columns_[run.begin], length);
		const RunSums sums = bits.sums();
		insert(run, {run.row, run.begin, run.end, 0, {sums.vertices(), sums.polygons(), sums.corners()}},
		       {length, length, sums.walked()});
		const bool exists[4] = {run.j > 0, run.j + 1 < cells_[1], run.k > 0, run.k + 1 < cells_[2]};
		const std::uint32_t rows[4] = {run.row - 1, run.row + 1, run.row - points_[1], run.row + points_[1]};
		for (unsigned side = 0; side < 4; ++side)
		{
			if (!exists[side])
				continue;
			const std::uint64_t mixed = bits.mixedColumns(side);
			const std::uint64_t cut = bits.cutFaces(side, mixed);
			std::uint64_t begins = cut & ~(cut << 4 & mixed);
			std::uint64_t ends = cut & ~(cut >> 4 & mixed >> 4);
			for (; begins; begins &= begins - 1, ends &= ends - 1)
				enter(rows[side], run.begin + std::countr_zero(begins) / 4, run.begin + std::countr_zero(ends) / 4,
				      side, queue);
		}
	}

	void insert(const Run& run, const Span& span, const SpanCells& cells)
	{
		store_.insert(thread_, span, {&columns_[run.begin], run.end - run.begin + 1}, cells);
		const unsigned last_j = run.j + 1 == cells_[1] ? 1 : 0;
		const unsigned last_k = run.k + 1 == cells_[2] ? 2 : 0;
		for (const unsigned beyond : {last_j, last_k, last_j && last_k ? 3u : 0u})
			if (beyond)
				addBeyond(run, beyond);
	}

	// Adds a span for the far points of the last cells, since no cells follow that would own their edges. Bit 0 of
	// `beyond`: the points at j + 1, bit 1: those at k + 1.
	void addBeyond(const Run& run, unsigned beyond)
	{
		Span span{run.row + (beyond & 1) + (beyond >> 1) * points_[1], run.begin, run.end, 0, {}};
		beyond_.clear();
		for (std::uint32_t i = run.begin; i <= run.end; ++i)
		{
			// The grid has no points there. They get the bits of the points before them.
			Column column = 0;
			for (unsigned r = 0; r < 4; ++r)
				column |= static_cast<Column>((columns_[i] >> (r | beyond) & 1) << r);
			beyond_.push_back(column);
		}
		for (std::size_t x = 0; x < beyond_.size(); ++x)
			span.counts.vertices +=
			    table_[cases::caseIndex(beyond_[x], beyond_[std::min(x + 1, beyond_.size() - 1)])].owned_count;
		store_.insert(thread_, span, beyond_, {});
	}

	// Queues one entry for every sequence of cut faces that leads to one run of cells across. A sequence ends where the
	// two points that it shares with the next face have the same sign, since the column there may be uniform.
	void enterNeighbors(const Run& run, std::vector<Entry>& queue)
	{
		struct Side
		{
			bool exists;
			Column pair; // bits of a column that lie on the side
			std::uint32_t row;
		};
		const Side sides[4] = {{run.j > 0, 0b0101, run.row - 1},
		                       {run.j + 1 < cells_[1], 0b1010, run.row + 1},
		                       {run.k > 0, 0b0011, run.row - points_[1]},
		                       {run.k + 1 < cells_[2], 0b1100, run.row + points_[1]}};
		for (unsigned side = 0; side < 4; ++side)
		{
			if (!sides[side].exists)
				continue;
			const auto isMixed = [&](std::uint32_t i)
			{
				const unsigned pair = columns_[i] & sides[side].pair;
				return pair != 0 && pair != sides[side].pair;
			};
			std::uint32_t from = run.end; // of the faces at hand; the run's end where there are none
			for (std::uint32_t i = run.begin; i < run.end; ++i)
			{
				const bool is_cut = !isLeftOut(i) && (caseAt(i).row_faces >> side & 1);
				if (from != run.end && (!is_cut || !isMixed(i)))
				{
					enter(sides[side].row, from, i - 1, side, queue);
					from = run.end;
				}
				if (is_cut && from == run.end)
					from = i;
			}
			if (from != run.end)
				enter(sides[side].row, from, run.end - 1, side, queue);
		}
	}

	// Queues rows diagonally across, if a cell has an edge there whose owner would be missing: with a window not every
	// cell around an edge is found.
	void enterOwners(const Run& run, std::vector<Entry>& queue)
	{
		if (run.j + 1 == cells_[1] || run.k + 1 == cells_[2])
			return;
		constexpr Column kFarthestRow = 0b1000;
		for (std::uint32_t i = run.begin; i < run.end; ++i)
			if (!isLeftOut(i) && ((columns_[i] ^ columns_[i + 1]) & kFarthestRow))
				enter(run.row + points_[1] + 1, i, i, 3, queue);
	}

	const LatticeCase& caseAt(std::uint32_t i) const { return table_[cases::caseIndex(columns_[i], columns_[i + 1])]; }
	bool isLeftOut(std::uint32_t i) const { return Extent::kLimits && (columns_[i] & cases::kLeftOut); }

	void enter(std::uint32_t row, std::uint32_t from, std::uint32_t to, unsigned side, std::vector<Entry>& queue)
	{
		if (store_.covers(row, from))
			return;
		// The two rows of points that the row does not share with this one.
		const PointId layer = points_[0] * points_[1];
		const PointId far = (side == 1 ? points_[0] : side == 3 ? layer : 0) + row * points_[0];
		const PointId also = side < 2 ? layer : points_[0];
		const PointId first = from ? from - 1 : 0;
		const PointId last = std::min(to + 2, cells_[0]);
		signs_.prefetch(far + first, far + last);
		signs_.prefetch(far + also + first, far + also + last);
		queue.push_back({row, static_cast<std::uint16_t>(from)});
	}

	const Signs& signs_;
	Extent extent_;
	SpanStore& store_;
	std::size_t thread_;
	std::array<std::uint32_t, 3> points_;
	std::array<std::uint32_t, 3> cells_;
	const std::array<LatticeCase, 256>& table_ = cases::latticeCases();
	std::vector<Column> columns_; // of the row at hand, at their i
	std::vector<Column> beyond_;
};

template <class Signs, class Extent>
void flood(const grid::Lattice& lattice, const Signs& signs, const Extent& extent, std::span<const CellId> seeds,
           SpanStore& store)
{
	std::vector<Entry> entries;
	for (const CellId seed : seeds)
	{
		const auto [i, j, k] = lattice.cellIndex(seed);
		entries.push_back({k * lattice.points()[1] + j, static_cast<std::uint16_t>(i)});
	}
	shareFlood(std::span<const Entry>(entries),
	           [&](FloodQueue<Entry>& queue)
	           {
		           Flooder<Signs, Extent> flooder(lattice, signs, extent, store);
		           queue.run([&](std::vector<Entry>& all, std::size_t at) { flooder.follow(all, all[at]); });
	           });
}

template <class Number>
void floodAs(const grid::CurvilinearGrid& grid, const Box& bounds, const surface::Plane& plane,
             const seed::SheetWindow* window, std::span<const CellId> seeds, SpanStore& store)
{
	const RowSigns<Number> signs(grid.coordinates(), plane, bounds);
	if (window)
		flood(grid, signs, RowWindow<Number>(grid, plane, *window, bounds), seeds, store);
	else
		flood(grid, signs, WholeSheet{}, seeds, store);
}

} // namespace

bool floodTakes(const grid::Lattice& lattice)
{
	return lattice.points()[0] <= SpanStore::kMaxRowCells &&
	       static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) <= SpanStore::kMaxThreads;
}

SpanCut floodSpans(const grid::CurvilinearGrid& grid, const Box& bounds, const surface::Plane& plane,
                   const seed::SheetWindow* window, std::span<const CellId> seeds, SpanStore& store)
{
	if (grid.coordinates().isDouble())
		floodAs<double>(grid, bounds, plane, window, seeds, store);
	else
		floodAs<float>(grid, bounds, plane, window, seeds, store);
	return store.collect();
}

} // namespace vp::find
