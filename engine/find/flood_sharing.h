#pragma once

#include "base/worker_piece.h"

#include <tbb/parallel_for_each.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace vp::find
{

// The entries that one thread of a flood has to look at. It appends what it finds. If other threads have nothing to do,
// it gives away entries from the end.
template <class Entry>
class FloodQueue
{
public:
	static constexpr std::size_t kBatch = 64; // smallest number of entries that is worth giving away

	using Batch = std::vector<Entry>;

	FloodQueue(Batch entries, std::atomic<int>& waiting, std::function<void(Batch)> give)
	    : entries_(std::move(entries)), waiting_(waiting), give_(std::move(give)),
	      others_(tbb::this_task_arena::max_concurrency() - 1)
	{
	}

	// follow(entries, at) looks at an entry, and may append more.
	template <class Follow>
	void run(Follow&& follow)
	{
		for (std::size_t at = 0; at < entries_.size(); ++at)
		{
			follow(entries_, at);
			if (entries_.size() - at > 2 * kBatch && waiting_.load(std::memory_order_relaxed) < others_)
			{
				give_(Batch(entries_.end() - kBatch, entries_.end()));
				entries_.resize(entries_.size() - kBatch);
			}
		}
	}

private:
	Batch entries_;
	std::atomic<int>& waiting_; // batches that nobody has begun
	std::function<void(Batch)> give_;
	int others_;
};

// Floods from the seeds on all cores, and returns when no entry is left. It calls work(FloodQueue<Entry>&) for each
// part of the work, which must run the queue.
template <class Entry, class Work>
void shareFlood(std::span<const Entry> seeds, Work&& work)
{
	using Batch = typename FloodQueue<Entry>::Batch;
	constexpr std::size_t kBatch = FloodQueue<Entry>::kBatch;
	std::vector<Batch> batches;
	for (std::size_t begin = 0; begin < seeds.size(); begin += kBatch)
	{
		const std::span<const Entry> batch = seeds.subspan(begin, std::min(kBatch, seeds.size() - begin));
		batches.emplace_back(batch.begin(), batch.end());
	}
	std::atomic<int> waiting{static_cast<int>(batches.size())};
	const TracedLoop loop;
	tbb::parallel_for_each(batches.begin(), batches.end(),
	                       [&](Batch& batch, tbb::feeder<Batch>& feeder)
	                       {
		                       const WorkerPiece piece(loop);
		                       --waiting;
		                       FloodQueue<Entry> queue(std::move(batch), waiting,
		                                               [&](Batch given)
		                                               {
			                                               ++waiting;
			                                               feeder.add(std::move(given));
		                                               });
		                       work(queue);
	                       });
}

} // namespace vp::find
