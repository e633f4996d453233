#include "traverse/span_flood.h"

#include "traverse/row_signs.h"

#include <tbb/parallel_for_each.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>
#include <vector>

namespace vp::traverse
{

namespace
{

using cases::Column;
using cases::LatticeCase;

// A cell of a row that is cut, and the last of the cells beside it that are cut across the same run of faces.
struct Entry
{
	std::uint32_t row;
	std::uint16_t cell;
	std::uint16_t last;
};
using Batch = std::vector<Entry>;

constexpr std::size_t kBatch = 64; // entries that are worth another thread's while

// The columns' bits, one byte each, of four points of a row whose bits are the index.
constexpr std::array<std::uint32_t, 16> kSpread = []
{
	std::array<std::uint32_t, 16> spread{};
	for (unsigned bits = 0; bits < spread.size(); ++bits)
		for (unsigned v = 0; v < 4; ++v)
			spread[bits] |= (bits >> v & 1u) << (std::endian::native == std::endian::little ? 8 * v : 24 - 8 * v);
	return spread;
}();

// What the threads of a flood share.
template <class Signs>
struct Flood
{
	const grid::Lattice& lattice;
	const Signs& signs;
	SpanStore& store;
	std::atomic<int> waiting{0}; // batches that no thread has begun
	int threads = tbb::this_task_arena::max_concurrency();
};

template <class Signs>
class Flooder
{
public:
	explicit Flooder(Flood<Signs>& flood)
	    : flood_(flood), thread_(static_cast<std::size_t>(tbb::this_task_arena::current_thread_index())),
	      points_(flood.lattice.points()), cells_(flood.lattice.cells()), columns_(points_[0] + 8)
	{
	}

	// share(Batch) gives entries away to another thread.
	template <class Share>
	void run(Batch queue, Share&& share)
	{
		queue_ = std::move(queue);
		for (std::size_t next = 0; next < queue_.size(); ++next)
		{
			follow(queue_[next]);
			if (queue_.size() - next > 2 * kBatch &&
			    flood_.waiting.load(std::memory_order_relaxed) < flood_.threads - 1)
			{
				share(Batch(queue_.end() - kBatch, queue_.end()));
				queue_.resize(queue_.size() - kBatch);
			}
		}
	}

private:
	// The four columns from 4 * quad on.
	unsigned takeColumns(std::uint32_t quad, PointId row_start)
	{
		const std::uint32_t at = 4 * quad;
		const PointId p = row_start + at;
		const PointId layer = points_[0] * points_[1];
		const PointId rows[4] = {p, p + points_[0], p + layer, p + layer + points_[0]};
		const unsigned count = std::min(4u, points_[0] - at);
		std::uint32_t columns = 0;
		unsigned any = 0;
		unsigned all = 15;
		for (unsigned r = 0; r < 4; ++r)
		{
			const unsigned bits = count == 4 ? flood_.signs.four(rows[r]) : flood_.signs.few(rows[r], count);
			any |= bits;
			all &= bits;
			columns |= kSpread[bits] << r;
		}
		std::memcpy(&columns_[at], &columns, 4);
		return ~(any & ~all) & ((1u << count) - 1);
	}

	// Follows the run of the entry's cell to both ends, and enters the rows beside it.
	void follow(const Entry entry) // by value: the queue grows meanwhile
	{
		if (flood_.store.covers(entry.row, entry.cell))
			return;
		const std::uint32_t k = entry.row / points_[1];
		const std::uint32_t j = entry.row - k * points_[1];
		const PointId row_start = entry.row * points_[0];
		const std::uint32_t quads = (points_[0] + 3) / 4;

		// The last uniform column up to the cell's own, and the first after it.
		const std::uint32_t quad = entry.cell / 4u;
		const unsigned uniform = takeColumns(quad, row_start);
		const unsigned up_to_cell = (2u << entry.cell % 4u) - 1;
		std::uint32_t begin = 0;
		unsigned ends = uniform & up_to_cell;
		for (std::uint32_t q = quad;;)
		{
			if (ends)
			{
				begin = 4 * q + static_cast<std::uint32_t>(std::bit_width(ends)) - 1;
				break;
			}
			if (q == 0)
				break;
			ends = takeColumns(--q, row_start);
		}
		std::uint32_t end = cells_[0];
		ends = uniform & ~up_to_cell;
		for (std::uint32_t q = quad;;)
		{
			if (ends)
			{
				end = 4 * q + static_cast<std::uint32_t>(std::countr_zero(ends));
				break;
			}
			if (++q == quads)
				break;
			ends = takeColumns(q, row_start);
		}
		if (columns_[begin] == columns_[end] && cases::isUniform(columns_[begin]) && end == begin + 1)
			return; // a seed that is not cut
		add(entry.row, begin, end);
		enterNeighbours(entry.row, j, k, begin, end);
		if (j + 1 == cells_[1])
			addBeyond(entry.row, begin, end, 1);
		if (k + 1 == cells_[2])
			addBeyond(entry.row, begin, end, 2);
		if (j + 1 == cells_[1] && k + 1 == cells_[2])
			addBeyond(entry.row, begin, end, 3);
	}

	void add(std::uint32_t row, std::uint32_t begin, std::uint32_t end)
	{
		Span span{row, begin, end, 0, {}};
		std::size_t walked = 0;
		for (std::uint32_t i = begin; i < end; ++i)
		{
			const LatticeCase& entry = table_[columns_[i] | columns_[i + 1] << 4];
			span.counts.vertices += entry.owned_count;
			span.counts.polygons += entry.edges != 0;
			span.counts.corners += entry.edges;
			walked += entry.needs_walk;
		}
		span.counts.vertices += table_[columns_[end] | columns_[end] << 4].owned_count;
		flood_.store.insert(thread_, span, {&columns_[begin], end - begin + 1}, end - begin, walked);
	}

	// The points of the cells' far rows, where no cells follow that would stand for them; bit 0 of `beyond`: of j + 1,
	// bit 1: of k + 1.
	void addBeyond(std::uint32_t row, std::uint32_t begin, std::uint32_t end, unsigned beyond)
	{
		Span span{row + (beyond & 1) + (beyond >> 1) * points_[1], begin, end, 0, {}};
		beyond_.clear();
		for (std::uint32_t i = begin; i <= end; ++i)
		{
			// A column of points that the grid has not: they take the bits of those before them.
			Column column = 0;
			for (unsigned r = 0; r < 4; ++r)
				column |= static_cast<Column>((columns_[i] >> (r | beyond) & 1) << r);
			beyond_.push_back(column);
		}
		for (std::size_t x = 0; x < beyond_.size(); ++x)
			span.counts.vertices += table_[beyond_[x] | beyond_[std::min(x + 1, beyond_.size() - 1)] << 4].owned_count;
		flood_.store.insert(thread_, span, beyond_, 0, 0);
	}

	// One entry for every run of cut faces that belongs to one run of cells across: it ends where the two points shared
	// with the next face have the same sign, since the column there may be uniform.
	void enterNeighbours(std::uint32_t row, std::uint32_t j, std::uint32_t k, std::uint32_t begin, std::uint32_t end)
	{
		struct Side
		{
			bool exists;
			Column pair; // bits of a column that lie on the side, beside each other
			unsigned shift;
			std::uint32_t row;
		};
		const Side sides[4] = {{j > 0, 0b0101, 2, row - 1},
		                       {j + 1 < cells_[1], 0b1010, 2, row + 1},
		                       {k > 0, 0b0011, 1, row - points_[1]},
		                       {k + 1 < cells_[2], 0b1100, 1, row + points_[1]}};
		for (unsigned side = 0; side < 4; ++side)
		{
			if (!sides[side].exists)
				continue;
			const auto isMixed = [&](std::uint32_t i)
			{
				const unsigned pair = columns_[i] & sides[side].pair;
				return pair != 0 && pair != sides[side].pair;
			};
			std::uint32_t run = end;
			bool mixed = isMixed(begin);
			for (std::uint32_t i = begin; i < end; ++i)
			{
				const bool is_cut = table_[columns_[i] | columns_[i + 1] << 4].row_faces >> side & 1;
				if (run != end && (!is_cut || !mixed))
				{
					enter(sides[side].row, run, i - 1, side);
					run = end;
				}
				if (is_cut && run == end)
					run = i;
				mixed = isMixed(i + 1);
			}
			if (run != end)
				enter(sides[side].row, run, end - 1, side);
		}
	}

	void enter(std::uint32_t row, std::uint32_t from, std::uint32_t to, unsigned side)
	{
		if (flood_.store.covers(row, from))
			return;
		// Of the row's four rows of points, the two that are new.
		const PointId layer = points_[0] * points_[1];
		const PointId far = (side == 1 ? points_[0] : side == 3 ? layer : 0) + row * points_[0];
		const PointId also = side < 2 ? layer : points_[0];
		const PointId first = from ? from - 1 : 0;
		const PointId last = std::min(to + 2, cells_[0]);
		flood_.signs.prefetch(far + first, far + last);
		flood_.signs.prefetch(far + also + first, far + also + last);
		queue_.push_back({row, static_cast<std::uint16_t>(from), static_cast<std::uint16_t>(to)});
	}

	Flood<Signs>& flood_;
	std::size_t thread_;
	std::array<std::uint32_t, 3> points_;
	std::array<std::uint32_t, 3> cells_;
	const std::array<LatticeCase, 256>& table_ = cases::latticeCases();
	std::vector<Column> columns_; // of the row at hand, at their i
	std::vector<Column> beyond_;
	Batch queue_;
};

template <class Signs>
void flood(const grid::Lattice& lattice, const Signs& signs, std::span<const CellId> seeds, SpanStore& store)
{
	const auto points_j = lattice.points()[1];
	std::vector<Batch> batches;
	for (const CellId seed : seeds)
	{
		if (batches.empty() || batches.back().size() == kBatch)
			batches.emplace_back();
		const auto [i, j, k] = lattice.cellIndex(seed);
		batches.back().push_back({k * points_j + j, static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(i)});
	}
	Flood<Signs> shared{lattice, signs, store};
	shared.waiting = static_cast<int>(batches.size());
	tbb::parallel_for_each(batches.begin(), batches.end(),
	                       [&](Batch& batch, tbb::feeder<Batch>& feeder)
	                       {
		                       --shared.waiting;
		                       Flooder<Signs>(shared).run(std::move(batch),
		                                                  [&](Batch shared_batch)
		                                                  {
			                                                  ++shared.waiting;
			                                                  feeder.add(std::move(shared_batch));
		                                                  });
	                       });
}

} // namespace

bool floodTakes(const grid::Lattice& lattice)
{
	return lattice.points()[0] <= SpanStore::kMaxRowCells &&
	       static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) <= SpanStore::kMaxThreads;
}

SpanCut floodSpans(const grid::CurvilinearGrid& grid, const Box& bounds, const surface::Plane& plane,
                   std::span<const CellId> seeds, SpanStore& store)
{
	if (grid.coordinates().isDouble())
		flood(grid, RowSigns<double>(grid.coordinates(), plane, bounds), seeds, store);
	else
		flood(grid, RowSigns<float>(grid.coordinates(), plane, bounds), seeds, store);
	return store.collect();
}

} // namespace vp::traverse
