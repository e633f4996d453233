#include "base/idle_threads.h"

#include <tbb/global_control.h>

namespace vp
{

bool endIdleThreads()
{
	tbb::task_scheduler_handle handle{tbb::attach{}};
	return tbb::finalize(handle, std::nothrow);
}

} // namespace vp
