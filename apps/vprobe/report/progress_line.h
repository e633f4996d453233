#pragma once

#include "base/progress.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace vp::app
{

// Shows on a terminal what takes long: after half a second it prints a line "reading FILE … 3 s" on standard error,
// renews it in place, and wipes it at the end. It prints nothing if standard error is not a terminal.
class ProgressLine
{
public:
	ProgressLine();
	~ProgressLine();
	ProgressLine(const ProgressLine&) = delete;
	ProgressLine& operator=(const ProgressLine&) = delete;

private:
	void say(std::string_view what); // an empty text shows nothing
	void show();
	void wipe();

	std::string what_;
	std::chrono::steady_clock::time_point since_;
	std::mutex mutex_;
	std::condition_variable changed_;
	bool done_ = false;
	bool shown_ = false;
	std::thread thread_; // not started if standard error is not a terminal
	ProgressListener listener_;
};

} // namespace vp::app
