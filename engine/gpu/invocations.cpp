#include "gpu/invocations.h"

#include <atomic>
#include <mutex>
#include <utility>

namespace vp::gpu
{

namespace
{

std::atomic<bool> counts_invocations = false;

struct CountedPasses
{
	std::mutex mutex;
	PassInvocations passes;
};

CountedPasses& countedPasses()
{
	static CountedPasses counted;
	return counted;
}

} // namespace

void countInvocations(bool on)
{
	counts_invocations = on;
}

bool countsInvocations()
{
	return counts_invocations.load(std::memory_order_relaxed);
}

void addInvocations(const char* pass, const Invocations& more)
{
	const std::lock_guard lock(countedPasses().mutex);
	Invocations& sum = countedPasses().passes[pass];
	sum.vertices += more.vertices;
	sum.fragments += more.fragments;
	sum.computes += more.computes;
}

PassInvocations takeInvocations()
{
	const std::lock_guard lock(countedPasses().mutex);
	return std::exchange(countedPasses().passes, {});
}

} // namespace vp::gpu
