#pragma once

#include "viewer/document.h"

#include <mutex>
#include <utility>

namespace vp::app
{

// What other threads leave for the window's. It outlives the document where they are slower.
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
