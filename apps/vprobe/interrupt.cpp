#include "interrupt.h"

#include <atomic>

namespace vp::app
{

namespace
{

std::atomic<bool> deferred = false;
std::atomic<int> waiting = 0; // the signal that came, or 0
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free); // a handler uses them

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
	return waiting != 0;
}

bool deferInterrupt(int signal) noexcept
{
	return deferred && waiting.exchange(signal) == 0;
}

int signalThatCame() noexcept
{
	return waiting;
}

} // namespace vp::app
