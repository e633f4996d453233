#pragma once

namespace vp::app
{

// Delays Ctrl-C, SIGTERM and the like as long as an object of this class exists: the work asks for it with came(). Use
// it while writing more files than a signal handler can remove. A second signal takes effect at once.
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
bool deferInterrupt(int signal) noexcept;

// Returns the signal that was delayed, or 0.
int signalThatCame() noexcept;

// Returns the exit status of a program that a signal has ended, as shells have it: 130 for Ctrl-C, 143 for SIGTERM.
constexpr int statusOfSignal(int signal)
{
	return 128 + signal;
}

} // namespace vp::app
