#pragma once

#include "interrupt.h"
#include "picture/painter.h"
#include "session/frame.h"
#include "sweep/frames.h"
#include "sweep/worker.h"
#include "write/slice_sets.h"

#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vp::app
{

// Writes what a sweep makes of its frames, in order. A picture is written on a thread of its own while the next one is
// drawn. An error in writing is reported before any error of a later frame.
class SweepProducts
{
public:
	// series: the .pvd file that the polygons go to, or empty.
	static Result<std::unique_ptr<SweepProducts>> create(session::Session& session,
	                                                     std::optional<picture::Painter> painter, Frames frames,
	                                                     const std::string& series);

	// True if frames become files: pictures or polygons, not only figures.
	bool makesFiles() const { return painter_ || interrupt_; }
	bool has(int frame) const { return frames_.has(frame); }

	// From now on a thread of its own writes the pictures.
	void writeBeside() { writer_.emplace("writer"); }

	// Fits camera and colors to these times (picture::Painter::fitTimes).
	Status fitTimes(std::span<const std::size_t> steps) { return painter_ ? painter_->fitTimes(steps) : Nothing{}; }

	// time: of the input, if the frames are its times.
	Status add(int frame, std::optional<double> time, const session::Frame& cut);
	Status finish(); // waits until everything that was added is written
	Status commit(); // puts the film, the exposure or the series in its place; call finish() first

private:
	SweepProducts(session::Session& session, std::optional<picture::Painter> painter, Frames frames)
	    : session_(session), frames_(std::move(frames)), painter_(std::move(painter))
	{
	}

	Status draw(int frame, const session::Frame& cut);
	void write(int frame, const render::Picture& picture);

	session::Session& session_;
	Frames frames_;
	std::optional<picture::Painter> painter_;
	std::unique_ptr<DeferredInterrupt> interrupt_; // if there is a series
	std::optional<write::SliceSeries> series_;     // at the process that writes
	Status written_ = Nothing{};                   // error of the writing thread
	std::atomic<bool> write_failed_ = false;       // stops the drawing
	std::optional<Worker> writer_;                 // must be the last member, since it uses the others
};

} // namespace vp::app
