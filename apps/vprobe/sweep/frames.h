#pragma once

#include "base/result.h"
#include "render/picture.h"
#include "sweep/exposure.h"
#include "write/film.h"
#include "write/frame_names.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace vp::app
{

// Says where the drawn frames of a sweep go. An empty name means nowhere.
struct FramePlaces
{
	std::string pictures; // a pattern that contains {frame}
	std::string film;
	std::string exposure;
	bool resume = false; // keep pictures that exist already
	bool writes = true;  // false: takes part in drawing what another process writes
};

// Writes the frames of a sweep as pictures, a film or an exposure.
class Frames
{
public:
	// Checks at once that every place can be written to, before the work begins. All pictures have the given size.
	static Result<Frames> create(const FramePlaces& places, std::uint32_t width, std::uint32_t height,
	                             double per_second);

	// Checks that no picture takes the place of a file that was read. Call it when all inputs are read.
	Status refuseInputs(int count) const;
	// Returns true if the frame need not be drawn. An exposure needs every frame.
	bool has(int frame) const;
	Status add(int frame, const render::Picture& picture);

	bool wantsExposure() const { return !places_.exposure.empty(); }
	void beginExposure(render::Picture empty) { exposure_.emplace(std::move(empty)); }

	// Puts the film and the exposure in their places.
	Status commit();

private:
	explicit Frames(FramePlaces places) : places_(std::move(places)) {}

	FramePlaces places_;
	std::optional<write::FrameNames> names_;
	std::optional<write::Film> film_;
	std::optional<Exposure> exposure_;
};

} // namespace vp::app
