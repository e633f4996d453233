#include "base/parallel_for.h"

#include "base/worker_piece.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace vp
{

void runLoop(const tbb::blocked_range<std::size_t>& range, LoopBody body, const std::stop_token* stop)
{
	const TracedLoop loop;
	tbb::parallel_for(range,
	                  [&](const tbb::blocked_range<std::size_t>& part)
	                  {
		                  const WorkerPiece piece(loop);
		                  if (!stop)
			                  return body(part.begin(), part.end());
		                  for (std::size_t begin = part.begin(); begin < part.end();)
		                  {
			                  throwIfStopped(stop);
			                  const std::size_t end = begin + std::min(part.end() - begin, part.grainsize());
			                  body(begin, end);
			                  begin = end;
		                  }
	                  });
}

} // namespace vp
