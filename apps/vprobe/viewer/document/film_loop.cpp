#include "viewer/document/film_loop.h"

#include <utility>

namespace vp::app
{

void FilmLoop::put(int frame, render::Picture picture)
{
	auto kept = std::make_shared<const render::Picture>(std::move(picture));
	const std::lock_guard lock(mutex_);
	recorded_ += pictures_[static_cast<std::size_t>(frame)] == nullptr;
	pictures_[static_cast<std::size_t>(frame)] = std::move(kept);
}

int FilmLoop::recorded() const
{
	const std::lock_guard lock(mutex_);
	return recorded_;
}

std::shared_ptr<const render::Picture> FilmLoop::picture(int frame) const
{
	const std::lock_guard lock(mutex_);
	return pictures_[static_cast<std::size_t>(frame)];
}

} // namespace vp::app
