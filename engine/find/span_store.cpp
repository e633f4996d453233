#include "find/span_store.h"

#include "base/parallel_for.h"

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

void SpanStore::Writer::insert(Span span, const SpanCells& cells)
{
	const std::size_t number = mine_.records;
	if (number % kChunk == 0)
	{
		if (number / kChunk == kChunks)
			throw std::length_error("a slice of more than 16 million spans");
		if (!mine_.chunks[number / kChunk])
			mine_.chunks[number / kChunk] = std::make_unique<Record[]>(kChunk);
	}
	Record& record = mine_[number];
	span.columns = static_cast<std::uint32_t>(mine_.used_columns);
	record.span = span;
	const std::uint64_t head = makeHead(span, thread_, number);
	std::atomic<std::uint64_t>& row = store_.heads_[span.row];
	record.older = row.load(std::memory_order_acquire);
	do
	{
		for (std::uint64_t other = record.older; other; other = store_.olderThan(other))
			if (firstOf(other) == span.begin)
				return;
	} while (!row.compare_exchange_weak(record.older, head, std::memory_order_acq_rel, std::memory_order_acquire));
	if (!record.older)
		mine_.touched[span.row / 64] |= 1ull << span.row % 64;
	++mine_.records;
	mine_.used_columns += span.end - span.begin + 1;
	mine_.cells += cells;
}

// Appends the spans of a row in their order. Most rows have one.
void SpanStore::takeRow(std::uint32_t row, SpanCut& cut)
{
	const std::size_t first = cut.spans.size();
	for (std::uint64_t head = heads_[row].load(std::memory_order_relaxed); head;)
	{
		const Found& found = foundOf(head);
		const Record& record = found[numberOf(head)];
		cut.spans.push_back(record.span);
		cut.spans.back().columns += static_cast<std::uint32_t>(found.first_column);
		head = record.older;
	}
	heads_[row].store(0, std::memory_order_relaxed);
	if (cut.spans.size() - first > 1) [[unlikely]]
		std::ranges::sort(cut.spans.begin() + static_cast<std::ptrdiff_t>(first), cut.spans.end(), {}, &Span::begin);
	SpanCounts counts = cut.counts;
	for (Span* span = cut.spans.data() + first; span != cut.spans.data() + cut.spans.size(); ++span)
		counts += std::exchange(span->counts, counts);
	cut.counts = counts;
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
		for (std::uint64_t ahead = rows; ahead; ahead &= ahead - 1)
			vp::prefetch(&recordOf(
			    heads_[word * 64 + static_cast<std::size_t>(std::countr_zero(ahead))].load(std::memory_order_relaxed)));
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
		of_thread->used_columns = 0;
		of_thread->cells = {};
	}
}

SpanCut SpanStore::collect()
{
	std::vector<Found*> finders;
	SpanCells cells;
	std::size_t spans = 0;
	std::size_t columns = 0;
	for (const std::unique_ptr<Found>& of_thread : found_)
		if (of_thread)
		{
			finders.push_back(of_thread.get());
			of_thread->first_column = columns;
			spans += of_thread->records;
			columns += of_thread->used_columns;
			cells += of_thread->cells;
		}
	// All cores take ranges of rows, which are then put one behind the other.
	constexpr std::size_t kSpansInPart = 2048;
	const std::size_t words = (rows_ + 63) / 64;
	std::vector<SpanCut> parts(std::clamp<std::size_t>(spans / kSpansInPart, 1, 64));
	const auto forParts = [&](auto&& act) { tracedFor(std::size_t(0), parts.size(), act); };
	forParts([&](std::size_t p)
	         { parts[p] = takeRows(words * p / parts.size(), words * (p + 1) / parts.size(), finders); });
	SpanCut cut = parts.size() == 1 ? std::move(parts[0]) : join(parts);
	cut.cells = cells;
	// Columns stay in the order in which the threads found them.
	cut.columns.resize(columns);
	for (const Found* of_thread : finders)
		std::copy_n(of_thread->columns.begin(), of_thread->used_columns,
		            cut.columns.begin() + static_cast<std::ptrdiff_t>(of_thread->first_column));
	clear(finders);
	return cut;
}

SpanCut SpanStore::join(std::span<const SpanCut> parts)
{
	struct Place
	{
		std::size_t span;
		SpanCounts counts;
	};
	std::vector<Place> places;
	SpanCut cut;
	std::size_t spans = 0;
	for (const SpanCut& part : parts)
	{
		places.push_back({spans, cut.counts});
		spans += part.spans.size();
		cut.counts += part.counts;
	}
	cut.spans.resize(spans);
	tracedFor(std::size_t(0), parts.size(),
	          [&](std::size_t p)
	          {
		          Span* to = cut.spans.data() + places[p].span;
		          for (Span span : parts[p].spans)
		          {
			          span.counts += places[p].counts;
			          *to++ = span;
		          }
	          });
	return cut;
}

} // namespace vp::find
