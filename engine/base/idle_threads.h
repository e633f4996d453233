#pragma once

namespace vp
{

// Ends the threads of tbb, which wait for work; the next loop starts others. A process that forks calls this before,
// since its child has none of them and would wait for them. Returns false, and ends none, if another thread is in such
// a loop, or has been in one and still lives.
bool endIdleThreads();

} // namespace vp
