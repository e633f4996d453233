#include "report/progress_line.h"

#include "report/console.h"

#include <fmt/format.h>

#include <unistd.h>

namespace vp::app
{

ProgressLine::ProgressLine() : listener_([this](std::string_view what) { say(what); })
{
	if (isatty(STDERR_FILENO))
		thread_ = std::thread([this] { show(); });
}

ProgressLine::~ProgressLine()
{
	if (!thread_.joinable())
		return;
	{
		const std::lock_guard lock(mutex_);
		done_ = true;
	}
	changed_.notify_one();
	thread_.join();
}

void ProgressLine::say(std::string_view what)
{
	{
		const std::lock_guard lock(mutex_);
		// Work that goes on under another text has been going on for as long.
		if (what_.empty())
			since_ = std::chrono::steady_clock::now();
		what_ = what;
		if (what_.empty())
			wipe(); // before anything else is printed
	}
	changed_.notify_one();
}

void ProgressLine::show()
{
	using namespace std::chrono_literals;
	std::unique_lock lock(mutex_);
	while (!done_)
	{
		const auto elapsed = std::chrono::steady_clock::now() - since_;
		if (!what_.empty() && elapsed >= 500ms)
		{
			printError(fmt::format("\r\033[K{} … {:.0f} s", what_, std::chrono::duration<double>(elapsed).count()));
			shown_ = true;
		}
		changed_.wait_for(lock, 500ms);
	}
	wipe();
}

void ProgressLine::wipe()
{
	if (shown_)
		printError("\r\033[K");
	shown_ = false;
}

} // namespace vp::app
