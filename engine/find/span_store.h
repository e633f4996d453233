#pragma once

#include "base/prefetch.h"
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

// The spans of a flood while it runs: every row knows those found in it, whichever thread found them. Takes the part
// of the visited marks, in 8 bytes a row instead of one a cell.
class SpanStore
{
public:
	static constexpr std::size_t kMaxThreads = 127;
	static constexpr std::size_t kMaxRowCells = 0xFFFF; // a head of a row keeps cells in 16 bits

	explicit SpanStore(std::size_t rows) : rows_(rows), heads_(std::make_unique<std::atomic<std::uint64_t>[]>(rows)) {}

	// Whether a span in the row holds the cell.
	bool covers(std::uint32_t row, std::uint32_t cell) const
	{
		for (std::uint64_t head = heads_[row].load(std::memory_order_acquire); head; head = olderThan(head))
			if (cell - firstOf(head) <= lastOf(head) - firstOf(head))
				return true;
		return false;
	}
	void prefetch(std::uint32_t row) const { vp::prefetch(&heads_[row]); }

	// Adds a span of a thread, 0 <= thread < kMaxThreads, `span.columns` aside. False when another thread has found it
	// in the meantime.
	bool insert(std::size_t thread, const Span& span, std::span<const cases::Column> columns, const SpanCells& cells);

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

	// What one thread found. Records stay where they are, since other threads read them.
	struct alignas(64) Found
	{
		std::array<std::unique_ptr<Record[]>, kChunks> chunks;
		std::size_t records = 0;
		std::vector<cases::Column> columns;
		std::vector<std::uint64_t> touched; // rows, a bit each, of which this thread found the first span
		SpanCells cells;

		Record& operator[](std::size_t i) { return chunks[i / kChunk][i % kChunk]; }
		const Record& operator[](std::size_t i) const { return chunks[i / kChunk][i % kChunk]; }
	};

	// A head: first and last cell of the span found last, 16 bits each; 7 bits its thread, 24 its record; 1 bit that
	// tells a row with spans from one without.
	static std::uint32_t firstOf(std::uint64_t head) { return head & 0xFFFF; }
	static std::uint32_t lastOf(std::uint64_t head) { return head >> 16 & 0xFFFF; }
	const Record& recordOf(std::uint64_t head) const { return (*found_[head >> 32 & 0x7F])[head >> 39 & 0xFFFFFF]; }
	std::uint64_t olderThan(std::uint64_t head) const { return recordOf(head).older; }
	static std::uint64_t makeHead(const Span& span, std::size_t thread, std::size_t record)
	{
		return span.begin | std::uint64_t(span.end - 1) << 16 | std::uint64_t(thread) << 32 |
		       std::uint64_t(record) << 39 | 1ull << 63;
	}

	Found& found(std::size_t thread);
	void takeRow(std::uint32_t row, SpanCut& cut);
	SpanCut takeRows(std::size_t begin, std::size_t end, std::span<Found* const> finders);
	static void clear(std::span<Found* const> finders);

	std::size_t rows_;
	std::unique_ptr<std::atomic<std::uint64_t>[]> heads_;
	std::array<std::unique_ptr<Found>, kMaxThreads> found_;
};

} // namespace vp::find
