#pragma once

#include "base/prefetch.h"
#include "find/column_word.h"
#include "find/span_cut.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vp::find
{

// The spans of a flood while it runs. Every row knows the spans found in it, whichever thread found them. The store
// replaces the visited marks, and takes 8 bytes a row instead of one byte a cell.
class SpanStore
{
	struct Found;

public:
	static constexpr std::size_t kMaxThreads = 127;
	static constexpr std::size_t kMaxRowCells = 0xFFFF; // a head of a row keeps cells in 16 bits

	explicit SpanStore(std::size_t rows) : rows_(rows), heads_(std::make_unique<std::atomic<std::uint64_t>[]>(rows)) {}

	// Returns true if a span in the row holds the cell.
	bool covers(std::uint32_t row, std::uint32_t cell) const
	{
		for (std::uint64_t head = heads_[row].load(std::memory_order_acquire); head; head = olderThan(head))
			if (cell - firstOf(head) <= lastOf(head) - firstOf(head))
				return true;
		return false;
	}
	void prefetch(std::uint32_t row) const { vp::prefetch(&heads_[row]); }

	// Adds the spans that one thread finds, 0 <= thread < kMaxThreads.
	class Writer
	{
	public:
		Writer(SpanStore& store, std::size_t thread) : store_(store), thread_(thread), mine_(store.found(thread)) {}

		// Returns where to write the columns of the next span. There is room behind them, since a ColumnWord writes too
		// many.
		cases::ColumnCase* room(std::size_t columns)
		{
			if (const std::size_t needed = mine_.used_columns + columns + ColumnWord::kColumns;
			    needed > mine_.columns.size())
				mine_.columns.resize(2 * needed);
			return &mine_.columns[mine_.used_columns];
		}
		// Adds the span whose columns have been written. `span.columns` is not used. Nothing happens if another thread
		// has found it in the meantime.
		void insert(Span span, const SpanCells& cells);

	private:
		SpanStore& store_;
		std::size_t thread_;
		Found& mine_;
	};

	// All that was inserted; leaves the store empty.
	SpanCut collect();

	std::size_t bytes() const { return rows_ * sizeof(heads_[0]); }

private:
	struct Record
	{
		std::uint64_t older; // the head of the row before
		Span span;
	};
	static constexpr std::size_t kChunk = 1 << 12; // records
	static constexpr std::size_t kChunks = 1 << 12;

	// The spans that one thread found. Records never move, since other threads read them.
	struct alignas(64) Found
	{
		std::array<std::unique_ptr<Record[]>, kChunks> chunks;
		std::size_t records = 0;
		RawVector<cases::ColumnCase> columns;
		std::size_t used_columns = 0;
		std::size_t first_column = 0;       // its place in the cut, once that is collected
		std::vector<std::uint64_t> touched; // rows, a bit each, of which this thread found the first span
		SpanCells cells;

		Record& operator[](std::size_t i) { return chunks[i / kChunk][i % kChunk]; }
		const Record& operator[](std::size_t i) const { return chunks[i / kChunk][i % kChunk]; }
	};

	// A head: first and last cell of the span found last, 16 bits each; 7 bits its thread, 24 its record; 1 bit that
	// tells a row with spans from one without.
	static std::uint32_t firstOf(std::uint64_t head) { return head & 0xFFFF; }
	static std::uint32_t lastOf(std::uint64_t head) { return head >> 16 & 0xFFFF; }
	const Found& foundOf(std::uint64_t head) const { return *found_[head >> 32 & 0x7F]; }
	static std::size_t numberOf(std::uint64_t head) { return head >> 39 & 0xFFFFFF; }
	const Record& recordOf(std::uint64_t head) const { return foundOf(head)[numberOf(head)]; }
	std::uint64_t olderThan(std::uint64_t head) const { return recordOf(head).older; }
	static std::uint64_t makeHead(const Span& span, std::size_t thread, std::size_t record)
	{
		return span.begin | std::uint64_t(span.end - 1) << 16 | std::uint64_t(thread) << 32 |
		       std::uint64_t(record) << 39 | 1ull << 63;
	}

	Found& found(std::size_t thread);
	void takeRow(std::uint32_t row, SpanCut& cut);
	SpanCut takeRows(std::size_t begin, std::size_t end, std::span<Found* const> finders);
	static SpanCut join(std::span<const SpanCut> parts);
	static void clear(std::span<Found* const> finders);

	std::size_t rows_;
	std::unique_ptr<std::atomic<std::uint64_t>[]> heads_;
	std::array<std::unique_ptr<Found>, kMaxThreads> found_;
};

} // namespace vp::find
