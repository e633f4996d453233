#include "interrupt.h"

#include <atomic>

namespace vp::app
{

namespace
{

std::atomic<bool> deferred = false;
std::atomic<bool> waiting = false;
static_assert(std::atomic<bool>::is_always_lock_free); // a signal handler may use it

} // namespace

DeferredInterrupt::DeferredInterrupt()
{
	deferred = true;
}

DeferredInterrupt::~DeferredInterrupt()
{
	deferred = false;
}

bool DeferredInterrupt::came() const
{
	return waiting;
}

bool deferInterrupt() noexcept
{
	return deferred && !waiting.exchange(true);
}

} // namespace vp::app
