#pragma once

#include "viewer/document/document.h"

#include <algorithm>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace vp::app
{

// Holds messages from other threads for the window's thread. It outlives the document if those threads are slower.
struct Document::Mail
{
	std::mutex mutex;
	std::vector<Notice> notices;
	std::vector<std::string> files; // files that are under way, or whose notice is not taken yet
	std::vector<std::string> ended;

	void expect(const std::string& file)
	{
		const std::lock_guard lock(mutex);
		files.push_back(file);
	}
	// Leaves the outcome of a file that was expected.
	void leave(const std::string& file, Notice notice)
	{
		const std::lock_guard lock(mutex);
		ended.push_back(file);
		notices.push_back(std::move(notice));
	}
	// Takes all notices that were left. The caller holds the mutex.
	std::vector<Notice> take()
	{
		for (const std::string& file : std::exchange(ended, {}))
			files.erase(std::ranges::find(files, file));
		return std::exchange(notices, {});
	}
	void leave(Notice notice)
	{
		const std::lock_guard lock(mutex);
		notices.push_back(std::move(notice));
	}
};

} // namespace vp::app
