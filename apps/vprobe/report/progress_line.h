#pragma once

#include "base/progress.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace vp::app
{

// Tells a terminal what takes its time: after half a second a line "reading FILE … 3 s" on standard error, renewed in
// place and wiped at the end. Silent where standard error is no terminal.
class ProgressLine
{
public:
	ProgressLine();
	~ProgressLine();
	ProgressLine(const ProgressLine&) = delete;
	ProgressLine& operator=(const ProgressLine&) = delete;

private:
	void say(std::string_view what); // empty: nothing
	void show();
	void wipe();

	std::string what_;
	std::chrono::steady_clock::time_point since_;
	std::mutex mutex_;
	std::condition_variable changed_;
	bool done_ = false;
	bool shown_ = false;
	std::thread thread_; // none where nobody watches
	ProgressListener listener_;
};

} // namespace vp::app
