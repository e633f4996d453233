#pragma once

namespace vp::app
{

// Delays Ctrl-C as long as an object of this class exists: the work asks for it with came(). Use it while writing more
// files than a signal handler can remove. A second Ctrl-C takes effect at once.
class DeferredInterrupt
{
public:
	DeferredInterrupt();
	~DeferredInterrupt();
	DeferredInterrupt(const DeferredInterrupt&) = delete;
	DeferredInterrupt& operator=(const DeferredInterrupt&) = delete;

	bool came() const;
};

// The signal handler calls this. Returns true if the interrupt has to wait.
bool deferInterrupt() noexcept;

} // namespace vp::app
