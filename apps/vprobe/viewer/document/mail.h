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
	std::vector<std::string> files; // that the render thread is to write, and those that are not told of yet
	std::vector<std::string> ended;

	void expect(const std::string& file)
	{
		const std::lock_guard lock(mutex);
		files.push_back(file);
	}
	// What became of a file that was expected.
	void leave(const std::string& file, Notice notice)
	{
		const std::lock_guard lock(mutex);
		ended.push_back(file);
		notices.push_back(std::move(notice));
	}
	// All that was left. The mutex is held.
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
