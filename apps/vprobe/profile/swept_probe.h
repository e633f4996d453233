#pragma once

#include "picture/painter.h"
#include "probe/path.h"
#include "profile/profile_options.h"
#include "session/frame.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// A profile measures this: an input, a probe, and the planes of a path, each of which is cut and perhaps drawn. Nothing
// is cut before the first plane, so that it shows what a first cut takes.
class SweptProbe
{
public:
	// Reads the input and builds what cuts it. options: those that checkSweep() lets pass.
	static Result<SweptProbe> open(const ProfileOptions& options);

	std::size_t planes() const { return poses_.size(); }
	Status measure(std::size_t plane);
	const session::Frame& made() const { return *made_; } // the frame of the last plane
	// Returns what was done since the last call.
	std::vector<Timeline::Section> takeSections() { return session_->timeline()->takeSections(); }
	const session::Session& session() const { return *session_; }
	const std::optional<std::string>& picture() const { return picture_; } // size and samples, if planes are drawn
	std::size_t pixels() const { return pixels_; }                         // 0 if nothing is drawn

private:
	SweptProbe() = default;

	std::unique_ptr<session::Session> session_;
	std::optional<picture::Painter> painter_;
	std::optional<std::string> picture_;
	std::size_t pixels_ = 0;
	probe::Path path_;
	std::vector<probe::Frame> poses_;
	std::shared_ptr<const session::Frame> made_;
};

// Checks without reading any input whether the options can be measured.
Status checkSweep(const ProfileOptions& options);

} // namespace vp::app
