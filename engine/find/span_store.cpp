#include "find/span_store.h"

#include <tbb/parallel_for.h>

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

// Appends the spans of a row in their order, each with its columns.
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

// Returns the spans of the rows from 64 * begin up to 64 * end.
SpanCut SpanStore::takeRows(std::size_t begin, std::size_t end, std::span<Found* const> finders)
{
	SpanCut cut;
	for (std::size_t word = begin; word < end; ++word)
	{
		std::uint64_t rows = 0;
		for (Found* of_thread : finders)
			rows |= std::exchange(of_thread->touched[word], 0);
		for (; rows; rows &= rows - 1)
			takeRow(static_cast<std::uint32_t>(word * 64 + static_cast<std::size_t>(std::countr_zero(rows))), cut);
	}
	return cut;
}

void SpanStore::clear(std::span<Found* const> finders)
{
	for (Found* of_thread : finders)
	{
		of_thread->records = 0;
		of_thread->columns.clear();
		of_thread->cells = {};
	}
}

SpanCut SpanStore::collect()
{
	std::vector<Found*> finders;
	SpanCut cut;
	std::size_t spans = 0;
	for (const std::unique_ptr<Found>& of_thread : found_)
		if (of_thread)
		{
			finders.push_back(of_thread.get());
			spans += of_thread->records;
			cut.cells += of_thread->cells;
		}
	// All cores take ranges of rows, which are then put one behind the other.
	constexpr std::size_t kSpansInPart = 2048;
	const std::size_t words = (rows_ + 63) / 64;
	std::vector<SpanCut> parts(std::clamp<std::size_t>(spans / kSpansInPart, 1, 64));
	const auto forParts = [&](auto&& act) { tbb::parallel_for(std::size_t(0), parts.size(), act); };
	forParts([&](std::size_t p)
	         { parts[p] = takeRows(words * p / parts.size(), words * (p + 1) / parts.size(), finders); });
	if (parts.size() == 1)
	{
		parts[0].cells = cut.cells;
		cut = std::move(parts[0]);
		clear(finders);
		return cut;
	}
	struct Place
	{
		std::size_t span;
		std::size_t column;
		SpanCounts counts;
	};
	std::vector<Place> places;
	std::size_t columns = 0;
	spans = 0;
	for (const SpanCut& part : parts)
	{
		places.push_back({spans, columns, cut.counts});
		spans += part.spans.size();
		columns += part.columns.size();
		cut.counts += part.counts;
	}
	cut.spans.resize(spans);
	cut.columns.resize(columns);
	forParts(
	    [&](std::size_t p)
	    {
		    const Place& place = places[p];
		    std::ranges::copy(parts[p].columns, cut.columns.begin() + static_cast<std::ptrdiff_t>(place.column));
		    Span* to = cut.spans.data() + place.span;
		    for (Span span : parts[p].spans)
		    {
			    span.columns += static_cast<std::uint32_t>(place.column);
			    span.counts += place.counts;
			    *to++ = span;
		    }
	    });
	clear(finders);
	return cut;
}

} // namespace vp::find
