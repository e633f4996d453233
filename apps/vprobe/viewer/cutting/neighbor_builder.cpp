#include "viewer/cutting/neighbor_builder.h"

#include "base/timeline.h"

#include <atomic>
#include <exception>
#include <thread>

namespace vp::app
{

struct NeighborBuilder::Job
{
	Result<grid::BlockSet> blocks;
	std::atomic<bool> done = false;
	std::jthread thread; // must be the last member

	explicit Job(const grid::BlockSet& listed) : blocks(listed)
	{
		thread = std::jthread(
		    [this]
		    {
			    nameThreadRow("neighbors");
			    try
			    {
				    grid::buildNeighbors(*blocks);
			    }
			    catch (const parts::Unreadable& unreadable)
			    {
				    blocks = Error{ErrorKind::input, unreadable.what()};
			    }
			    catch (const std::exception&) // out of memory, or too many faces to number
			    {
				    blocks =
				        Error{ErrorKind::input, "the neighbors of the cells do not fit into memory; only sheets can "
				                                "be shown, and nothing beside them"};
			    }
			    done = true;
		    });
	}
};

NeighborBuilder::NeighborBuilder() = default;
NeighborBuilder::~NeighborBuilder() = default;

void NeighborBuilder::begin(const grid::BlockSet& blocks)
{
	if (!job_ && !failure_)
		job_ = std::make_unique<Job>(blocks);
}

void NeighborBuilder::drop()
{
	failure_.reset();
	std::erase_if(dropped_, [](const auto& job) { return job->done.load(); });
	if (job_)
		dropped_.push_back(std::move(job_));
}

Result<std::optional<grid::BlockSet>> NeighborBuilder::take(bool waits)
{
	std::optional<grid::BlockSet> none;
	if (job_ && (waits || job_->done))
	{
		const std::unique_ptr<Job> job = std::move(job_);
		job->thread.join();
		if (job->blocks)
			return std::optional(std::move(*job->blocks));
		failure_ = job->blocks.error();
	}
	if (waits && failure_)
		return *failure_;
	return none;
}

} // namespace vp::app
