#pragma once

#include "base/result.h"
#include "render/picture.h"
#include "report/exposure.h"
#include "write/film.h"
#include "write/frame_names.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace vp::app
{

// Where the drawn frames of a sweep are to go. Empty names: nowhere.
struct FramePlaces
{
	std::string pictures; // a pattern with {frame}
	std::string film;
	std::string exposure;
	bool resume = false; // pictures that are there stay
};

// Pictures, a film or an exposure made of a sweep's frames.
class Frames
{
public:
	// Every place is tried: better than after the work. All pictures are of this size.
	static Result<Frames> create(const FramePlaces& places, std::uint32_t width, std::uint32_t height,
	                             double per_second);

	// The frame need not be drawn. An exposure needs them all.
	bool has(int frame) const;
	Status add(int frame, const render::Picture& picture);

	bool wantsExposure() const { return !places_.exposure.empty(); }
	void beginExposure(render::Picture empty) { exposure_.emplace(std::move(empty)); }

	// The film and the exposure appear.
	Status commit();

private:
	explicit Frames(FramePlaces places) : places_(std::move(places)) {}

	FramePlaces places_;
	std::optional<write::FrameNames> names_;
	std::optional<write::Film> film_;
	std::optional<Exposure> exposure_;
};

} // namespace vp::app
