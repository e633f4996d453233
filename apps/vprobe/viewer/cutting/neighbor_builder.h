#pragma once

#include "base/result.h"
#include "grid/block.h"

#include <memory>
#include <optional>
#include <vector>

namespace vp::app
{

/// Builds the neighbors of cells on a thread of its own, while cuts go on without them. Only one thread uses this
/// object.
class NeighborBuilder
{
public:
	NeighborBuilder();
	~NeighborBuilder(); // waits for the thread

	/// Begins to build for a copy of the blocks, which shares their arrays. Does nothing if a build is under way, or
	/// has failed.
	void begin(const grid::BlockSet& blocks);
	/// Call this when the blocks have changed. Cancels a build that is under way.
	void drop();
	/// Returns the blocks with neighbors, once. Returns nothing if they are not ready yet, or if the build has failed.
	/// With `waits`, call begin() first; then a failure is an error.
	Result<std::optional<grid::BlockSet>> take(bool waits);

private:
	struct Job;

	std::unique_ptr<Job> job_;
	std::optional<Error> failure_;
	std::vector<std::unique_ptr<Job>> dropped_; // cancelled, but not finished yet
};

} // namespace vp::app
