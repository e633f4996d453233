#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace vp
{

// Tells a terminal what takes its time: after half a second a line "reading FILE … 3 s" on standard error, renewed in
// place and wiped at the end. Silent where standard error is no terminal.
class Progress
{
public:
	explicit Progress(std::string what);
	~Progress();
	Progress(const Progress&) = delete;
	Progress& operator=(const Progress&) = delete;

	void say(std::string what); // from now on

private:
	void show();

	std::string what_;
	std::mutex mutex_;
	std::condition_variable done_changed_;
	bool done_ = false;
	std::thread thread_;
};

} // namespace vp
