#pragma once

#include "base/result.h"
#include "grid/block.h"

#include <memory>
#include <optional>
#include <vector>

namespace vp::app
{

/// Builds the neighbors of cells on a thread of its own, while cuts go on without them. Of one thread.
class NeighborBuilder
{
public:
	NeighborBuilder();
	~NeighborBuilder(); // waits for what is under way

	/// Begins with a copy of the blocks, which shares their arrays. Nothing where one is under way, or has failed.
	void begin(const grid::BlockSet& blocks);
	/// The blocks are others now: what is under way is of no use any more.
	void drop();
	/// The blocks with neighbors, once. None where they are not ready yet or have failed. With `waits`, for which
	/// begin() has been called, a failure is an error.
	Result<std::optional<grid::BlockSet>> take(bool waits);

private:
	struct Job;

	std::unique_ptr<Job> job_;
	std::optional<Error> failure_;
	std::vector<std::unique_ptr<Job>> dropped_; // cancelled, but not at their end yet
};

} // namespace vp::app
