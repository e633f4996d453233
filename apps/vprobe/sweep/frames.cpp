#include "sweep/frames.h"

#include "write/atomic_file.h"
#include "write/png.h"

#include <filesystem>

namespace vp::app
{

Result<Frames> Frames::create(const FramePlaces& places, std::uint32_t width, std::uint32_t height, double per_second)
{
	Frames frames(places);
	if (!places.writes)
		return frames;
	if (!places.exposure.empty())
		if (Status free = write::checkWritable(places.exposure); !free)
			return free.error();
	if (!places.pictures.empty())
	{
		Result<write::FrameNames> names = write::FrameNames::create(places.pictures);
		if (!names)
			return names.error();
		frames.names_ = std::move(*names);
	}
	if (!places.film.empty())
	{
		Result<write::Film> film = write::Film::create(places.film, width, height, per_second);
		if (!film)
			return film.error();
		frames.film_.emplace(std::move(*film));
	}
	return frames;
}

Status Frames::refuseInputs(int count) const
{
	for (int frame = 0; names_ && frame < count; ++frame)
		if (Status free = write::refuseInput(names_->of(frame)); !free)
			return free;
	return Nothing{};
}

bool Frames::has(int frame) const
{
	return places_.resume && !wantsExposure() && names_ && std::filesystem::exists(names_->of(frame));
}

Status Frames::add(int frame, const render::Picture& picture)
{
	if (exposure_ && places_.writes)
		exposure_->add(picture);
	if (names_)
		return write::writePng(picture, names_->of(frame));
	return film_ ? film_->add(picture) : Nothing{};
}

Status Frames::commit()
{
	if (exposure_ && places_.writes)
		if (Status written = write::writePng(exposure_->picture(), places_.exposure); !written)
			return written;
	return film_ ? film_->commit() : Nothing{};
}

} // namespace vp::app
