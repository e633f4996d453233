#pragma once

namespace vp::app
{

// While one lives, Ctrl-C waits until the work asks for it: for what consists of more files than a signal handler can
// remove. A second Ctrl-C does not wait.
class DeferredInterrupt
{
public:
	DeferredInterrupt();
	~DeferredInterrupt();
	DeferredInterrupt(const DeferredInterrupt&) = delete;
	DeferredInterrupt& operator=(const DeferredInterrupt&) = delete;

	bool came() const;
};

// For the signal handler: true where the interrupt is to wait.
bool deferInterrupt() noexcept;

} // namespace vp::app
