#include "find/span_store.h"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

namespace vp::find
{

SpanStore::Found& SpanStore::found(std::size_t thread)
{
	if (!found_[thread])
	{
		found_[thread] = std::make_unique<Found>();
		found_[thread]->touched.resize((rows_ + 63) / 64);
	}
	return *found_[thread];
}

bool SpanStore::insert(std::size_t thread, const Span& span, std::span<const cases::Column> columns,
                       const SpanCells& cells)
{
	Found& mine = found(thread);
	const std::size_t number = mine.records;
	if (number % kChunk == 0)
	{
		if (number / kChunk == kChunks)
			throw std::length_error("a slice of more than 16 million spans");
		if (!mine.chunks[number / kChunk])
			mine.chunks[number / kChunk] = std::make_unique<Record[]>(kChunk);
	}
	Record& record = mine[number];
	record.span = span;
	record.span.columns = static_cast<std::uint32_t>(mine.columns.size());
	const std::uint64_t head = makeHead(span, thread, number);
	record.older = heads_[span.row].load(std::memory_order_acquire);
	do
	{
		for (std::uint64_t other = record.older; other; other = olderThan(other))
			if (firstOf(other) == span.begin)
				return false;
	} while (!heads_[span.row].compare_exchange_weak(record.older, head, std::memory_order_acq_rel,
	                                                 std::memory_order_acquire));
	if (!record.older)
		mine.touched[span.row / 64] |= 1ull << span.row % 64;
	++mine.records;
	mine.columns.insert(mine.columns.end(), columns.begin(), columns.end());
	mine.cells += cells;
	return true;
}

// In the row's order, each with the columns of its thread.
void SpanStore::takeRow(std::uint32_t row, SpanCut& cut)
{
	const std::size_t first = cut.spans.size();
	for (std::uint64_t head = heads_[row].load(std::memory_order_relaxed); head; head = olderThan(head))
	{
		Span span = recordOf(head).span;
		const cases::Column* columns = found_[head >> 32 & 0x7F]->columns.data() + span.columns;
		span.columns = static_cast<std::uint32_t>(cut.columns.size());
		cut.columns.insert(cut.columns.end(), columns, columns + (span.end - span.begin + 1));
		cut.spans.push_back(span);
	}
	heads_[row].store(0, std::memory_order_relaxed);
	if (cut.spans.size() - first > 1)
		std::ranges::sort(cut.spans.begin() + static_cast<std::ptrdiff_t>(first), cut.spans.end(), {}, &Span::begin);
	for (std::size_t s = first; s < cut.spans.size(); ++s)
	{
		const SpanCounts own = cut.spans[s].counts;
		cut.spans[s].counts = cut.counts;
		cut.counts += own;
	}
}

SpanCut SpanStore::collect()
{
	std::vector<Found*> finders;
	for (const std::unique_ptr<Found>& of_thread : found_)
		if (of_thread)
			finders.push_back(of_thread.get());
	SpanCut cut;
	std::size_t spans = 0;
	std::size_t columns = 0;
	for (const Found* of_thread : finders)
	{
		spans += of_thread->records;
		columns += of_thread->columns.size();
		cut.cells += of_thread->cells;
	}
	cut.spans.reserve(spans);
	cut.columns.reserve(columns);
	for (std::size_t code = 0; code < (rows_ + 63) / 64; ++code)
	{
		std::uint64_t rows = 0;
		for (Found* of_thread : finders)
			rows |= std::exchange(of_thread->touched[code], 0);
		for (; rows; rows &= rows - 1)
			takeRow(static_cast<std::uint32_t>(code * 64 + static_cast<std::size_t>(std::countr_zero(rows))), cut);
	}
	for (Found* of_thread : finders)
	{
		of_thread->records = 0;
		of_thread->columns.clear();
		of_thread->cells = {};
	}
	return cut;
}

} // namespace vp::find
