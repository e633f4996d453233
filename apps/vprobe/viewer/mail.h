#pragma once

#include "viewer/document.h"

#include <mutex>
#include <utility>

namespace vp::app
{

// Holds messages from other threads for the window's thread. It outlives the document if those threads are slower.
struct Document::Mail
{
	std::mutex mutex;
	std::vector<Notice> notices;

	void leave(Notice notice)
	{
		const std::lock_guard lock(mutex);
		notices.push_back(std::move(notice));
	}
};

} // namespace vp::app
