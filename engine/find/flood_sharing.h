#pragma once

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

// The entries that one thread of a flood has before it. What it finds it appends; when others have nothing to do, it
// gives away from the end.
template <class Entry>
class FloodQueue
{
public:
	static constexpr std::size_t kBatch = 64; // entries that are worth another thread's while

	using Batch = std::vector<Entry>;

	FloodQueue(Batch entries, std::atomic<int>& waiting, std::function<void(Batch)> give)
	    : entries_(std::move(entries)), waiting_(waiting), give_(std::move(give)),
	      others_(tbb::this_task_arena::max_concurrency() - 1)
	{
	}

	// follow(entries, at): looks at an entry, and may append others.
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

// Floods from the seeds on all cores; returns when nothing is left. work(FloodQueue<Entry>&) is called for each part
// of the work and runs the queue.
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
	tbb::parallel_for_each(batches.begin(), batches.end(),
	                       [&](Batch& batch, tbb::feeder<Batch>& feeder)
	                       {
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
