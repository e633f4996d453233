#pragma once

#include "viewer/document.h"

#include <mutex>
#include <utility>

namespace vp::app
{

// What other threads leave for the window's. It outlives the bench where they are slower.
struct Document::Mail
{
	std::mutex mutex;
	std::vector<Notice> notices;
	std::optional<Error> frame_failed; // of a recording
	std::shared_ptr<Exposure> exposure;

	// A recorded frame. Only the render thread's thread adds to the exposure.
	void leave(Result<render::Picture> picture, int frame, FilmLoop& film)
	{
		std::shared_ptr<Exposure> exposed;
		{
			const std::lock_guard lock(mutex);
			if (!picture)
				frame_failed = picture.error();
			exposed = exposure;
		}
		if (picture && exposed)
			exposed->add(*picture);
		if (picture)
			film.put(frame, std::move(*picture));
	}

	void leave(Notice notice)
	{
		const std::lock_guard lock(mutex);
		notices.push_back(std::move(notice));
	}
};

} // namespace vp::app
