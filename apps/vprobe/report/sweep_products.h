#pragma once

#include "interrupt.h"
#include "report/frames.h"
#include "report/worker.h"
#include "session/cut_frame.h"
#include "session/painter.h"
#include "write/slice_sets.h"

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// What a sweep makes of its frames, one after the other. A picture is written on a thread of its own while the next
// one is drawn; what goes wrong there is told before what goes wrong with any later frame.
class SweepProducts
{
public:
	// series: the .pvd that polygons go to; empty: none.
	static Result<std::unique_ptr<SweepProducts>> create(session::Session& session,
	                                                     std::optional<session::Painter> painter, Frames frames,
	                                                     const std::string& series);

	bool has(int frame) const { return frames_.has(frame); }
	session::Painter* painter() { return painter_ ? &*painter_ : nullptr; }

	// Pictures go to a thread of their own from now on.
	void writeBeside() { writer_.emplace("writer"); }

	Status add(int frame, const session::CutFrame& cut);
	Status finish(); // waits until all is written that was added
	Status commit(); // once it is: the film, the exposure or the series appears

private:
	SweepProducts(session::Session& session, std::optional<session::Painter> painter, Frames frames)
	    : session_(session), frames_(std::move(frames)), painter_(std::move(painter))
	{
	}

	Status draw(int frame, const session::CutFrame& cut);
	void write(int frame, const render::Picture& picture);

	session::Session& session_;
	Frames frames_;
	std::optional<session::Painter> painter_;
	std::unique_ptr<DeferredInterrupt> interrupt_;
	std::optional<write::SliceSeries> series_;
	Status written_ = Nothing{};             // the writer's
	std::atomic<bool> write_failed_ = false; // so that no more is drawn
	std::optional<Worker> writer_;           // the last to be made: it uses the others
};

} // namespace vp::app
