#include "find/spans.h"

#include "find/column_word.h"
#include "find/flood_sharing.h"
#include "find/row_signs.h"
#include "find/row_window.h"
#include "find/span_store.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

namespace vp::find
{

namespace
{

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

	std::uint32_t cells() const { return end - begin; }
};

template <class Signs, class Extent>
class Flooder
{
public:
	Flooder(const grid::Lattice& lattice, const Signs& signs, const Extent& extent, SpanStore& store)
	    : signs_(signs), extent_(extent), store_(store),
	      writer_(store, static_cast<std::size_t>(tbb::this_task_arena::current_thread_index())),
	      points_(lattice.points()), cells_(lattice.cells()), quads_(points_[0] / 4 + 5)
	{
	}

	// Follows the run of the entry's cell to both ends, and queues the runs beside it.
	void follow(std::vector<Entry>& queue, const Entry entry)
	{
		if (const std::optional<Run> run = findRun(entry))
		{
			take(*run, queue);
			if (run->j + 1 == cells_[1] || run->k + 1 == cells_[2])
				addBeyond(*run);
		}
	}

private:
	// Computes the four columns from 4 * quad on. Returns a bit for each whose points agree, as uniformColumns() does.
	unsigned takeColumns(std::uint32_t quad, PointId row_start)
	{
		const std::uint32_t at = 4 * quad;
		const PointId p = row_start + at;
		const PointId layer = points_[0] * points_[1];
		const std::array<PointId, 4> rows = {p, p + points_[0], p + layer, p + layer + points_[0]};
		const unsigned count = std::min(4u, points_[0] - at);
		const unsigned columns = signs_.columns(rows, count);
		quads_[quad] = static_cast<std::uint16_t>(columns);
		return uniformColumns(columns) & ((1u << 4 * count) - 1);
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
		const unsigned up_to_cell = (2u << 4 * (entry.cell % 4u)) - 1;
		const Run run{entry.row, entry.row - k * points_[1], k, lastUniform(quad, uniform & up_to_cell, row_start),
		              firstUniform(quad, uniform & ~up_to_cell, row_start)};
		if (run.cells() == 1)
		{
			const ColumnWord word = ColumnWord::at(quads_.data(), run.begin);
			if (word.column(0) == word.column(1) && (word.column(0) == 0 || word.column(0) == 15))
				return std::nullopt;
		}
		return run;
	}
	// Returns the last uniform column up to a quad, 0 if there is none. `uniform` says which columns of the quad are
	// candidates.
	std::uint32_t lastUniform(std::uint32_t quad, unsigned uniform, PointId row_start)
	{
		for (; !uniform; uniform = takeColumns(--quad, row_start))
			if (quad == 0)
				return 0;
		return 4 * quad + (static_cast<std::uint32_t>(std::bit_width(uniform)) - 1) / 4;
	}
	// Returns the first uniform column from a quad on, the last column of the row if there is none.
	std::uint32_t firstUniform(std::uint32_t quad, unsigned uniform, PointId row_start)
	{
		for (; !uniform; uniform = takeColumns(++quad, row_start))
			if (4 * (quad + 1) >= points_[0])
				return cells_[0];
		return 4 * quad + static_cast<std::uint32_t>(std::countr_zero(uniform)) / 4;
	}

	// Adds the span of a run, and queues the runs beside it, a word of columns after the other.
	void take(const Run& run, std::vector<Entry>& queue)
	{
		const std::uint8_t* left_out = extent_.leftOut(run.row, run.begin, run.end);
		cases::ColumnCase* columns = writer_.room(run.cells() + 1);
		Span span{run.row, run.begin, run.end, 0, {}};
		SpanCells cells{run.cells(), 0, 0};
		for (std::uint32_t i = run.begin; i < run.end; i += ColumnWord::kMaxCells)
		{
			const std::uint32_t count = std::min(ColumnWord::kMaxCells, run.end - i);
			const ColumnWord word = ColumnWord::at(quads_.data(), i);
			cases::ColumnCase* to = columns + (i - run.begin);
			word.writeCases(to);
			std::uint64_t taken = ColumnWord::firstCells(count);
			if constexpr (Extent::kLimits)
				for (std::uint32_t x = 0; x < count; ++x)
					if (left_out[i + x])
					{
						to[x] |= cases::kLeftOut;
						taken &= ~(std::uint64_t(1) << 4 * x);
					}
			CellSums sums;
			for (std::uint32_t x = 0; x < count; ++x)
				sums.packed += sums_[to[x]].packed;
			span.counts += {sums.vertices(), sums.polygons(), sums.corners()};
			cells.cut += Extent::kLimits ? static_cast<std::size_t>(std::popcount(taken)) : count;
			cells.walked += sums.walked();
			enterBeside(run, i, word, taken, queue);
		}
		span.counts.vertices += endColumns(columns, run, 0);
		writer_.insert(span, cells);
	}

	// Writes the last of a run's columns. Returns how many vertices its point owns.
	std::uint32_t endColumns(cases::ColumnCase* columns, const Run& run, unsigned beyond) const
	{
		const unsigned last = ColumnWord::at(quads_.data(), run.end).beyond(beyond).column(0);
		columns[run.cells()] = static_cast<cases::ColumnCase>(last | last << 4);
		return sums_[last | last << 4].vertices();
	}

	// Adds spans for the far points of the last cells, since no cells follow that would own their edges.
	void addBeyond(const Run& run)
	{
		const unsigned last_j = run.j + 1 == cells_[1] ? 1 : 0;
		const unsigned last_k = run.k + 1 == cells_[2] ? 2 : 0;
		for (const unsigned beyond : {last_j, last_k, last_j && last_k ? 3u : 0u})
		{
			if (!beyond)
				continue;
			cases::ColumnCase* columns = writer_.room(run.cells() + 1);
			Span span{run.row + (beyond & 1) + (beyond >> 1) * points_[1], run.begin, run.end, 0, {}};
			for (std::uint32_t i = run.begin; i < run.end; i += ColumnWord::kMaxCells)
				ColumnWord::at(quads_.data(), i).beyond(beyond).writeCases(columns + (i - run.begin));
			for (std::uint32_t x = 0; x < run.cells(); ++x)
				span.counts.vertices += sums_[columns[x]].vertices();
			span.counts.vertices += endColumns(columns, run, beyond);
			writer_.insert(span, {});
		}
	}

	// Queues the runs beside the cells from i on that `taken` names.
	void enterBeside(const Run& run, std::uint32_t i, const ColumnWord& word, std::uint64_t taken,
	                 std::vector<Entry>& queue)
	{
		if (run.j > 0)
			enterSide<0>(run.row - 1, i, word, taken, queue);
		if (run.j + 1 < cells_[1])
			enterSide<1>(run.row + 1, i, word, taken, queue);
		if (run.k > 0)
			enterSide<2>(run.row - points_[1], i, word, taken, queue);
		if (run.k + 1 < cells_[2])
			enterSide<3>(run.row + points_[1], i, word, taken, queue);
		// With a window not every cell around an edge is found. So rows diagonally across are queued too, if a cell has
		// an edge there whose owner would be missing.
		if (Extent::kLimits && run.j + 1 < cells_[1] && run.k + 1 < cells_[2])
			for (std::uint64_t cut = word.cutInFarthestRow(taken); cut; cut &= cut - 1)
			{
				const std::uint32_t x = static_cast<std::uint32_t>(std::countr_zero(cut)) / 4;
				enter<3>(run.row + points_[1] + 1, i + x, i + x, queue);
			}
	}

	// Queues one entry for every sequence of cut faces that leads to one run of cells across. A sequence ends where the
	// two points that it shares with the next face have the same sign, since the column there may be uniform.
	template <unsigned side>
	void enterSide(std::uint32_t row, std::uint32_t i, const ColumnWord& word, std::uint64_t taken,
	               std::vector<Entry>& queue)
	{
		const std::uint64_t mixed = word.mixedColumns<side>();
		const std::uint64_t cut = word.cutFaces<side>(mixed, taken);
		std::uint64_t begins = cut & ~(cut << 4 & mixed);
		std::uint64_t ends = cut & ~((cut & mixed) >> 4);
		for (; begins; begins &= begins - 1, ends &= ends - 1)
			enter<side>(row, i + static_cast<std::uint32_t>(std::countr_zero(begins)) / 4,
			            i + static_cast<std::uint32_t>(std::countr_zero(ends)) / 4, queue);
	}

	template <unsigned side>
	void enter(std::uint32_t row, std::uint32_t from, std::uint32_t to, std::vector<Entry>& queue)
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
	SpanStore::Writer writer_;
	std::array<std::uint32_t, 3> points_;
	std::array<std::uint32_t, 3> cells_;
	const std::array<CellSums, cases::kColumnCases>& sums_ = cellSums();
	std::vector<std::uint16_t> quads_; // columns of the row at hand, four each
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
