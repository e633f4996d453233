#include "base/progress.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <unistd.h>

namespace vp
{

Progress::Progress(std::string what) : what_(std::move(what))
{
	if (isatty(STDERR_FILENO))
		thread_ = std::thread([this] { show(); });
}

Progress::~Progress()
{
	if (!thread_.joinable())
		return;
	{
		const std::lock_guard lock(mutex_);
		done_ = true;
	}
	done_changed_.notify_one();
	thread_.join();
}

void Progress::say(std::string what)
{
	const std::lock_guard lock(mutex_);
	what_ = std::move(what);
}

void Progress::show()
{
	using namespace std::chrono_literals;
	const auto start = std::chrono::steady_clock::now();
	bool shown = false;
	std::unique_lock lock(mutex_);
	while (!done_changed_.wait_for(lock, 500ms, [this] { return done_; }))
	{
		const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
		fmt::print(stderr, "\r\033[K{} … {:.0f} s", what_, elapsed.count());
		std::fflush(stderr);
		shown = true;
	}
	if (shown)
	{
		fmt::print(stderr, "\r\033[K");
		std::fflush(stderr);
	}
}

} // namespace vp
