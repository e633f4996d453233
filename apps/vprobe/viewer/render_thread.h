#pragma once

#include "gpu/image.h"
#include "session/cut_frame.h"
#include "session/painter.h"
#include "view/view_spec.h"
#include "viewer/gpu_pictures.h"
#include "viewer/neighbor_builder.h"
#include "viewer/sheet_lookups.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

namespace vp::app
{

struct PixelSize
{
	std::uint32_t width = 0;
	std::uint32_t height = 0;
};

using Moment = std::chrono::steady_clock::time_point;

inline double millisecondsSince(Moment start)
{
	return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// A second picture: a sheet of the probe alone, seen straight on.
struct PaneWish
{
	std::size_t sheet = 0;
	PixelSize size{};

	bool operator==(const PaneWish& other) const
	{
		return sheet == other.sheet && size.width == other.size.width && size.height == other.size.height;
	}
};

// What is to be seen, or kept.
struct FrameRequest
{
	std::uint64_t number = 0; // rising
	view::ViewSpec spec;      // its size is the picture's
	Moment since{};           // the oldest input that has not been answered by a picture
	std::optional<PaneWish> pane{};
	std::optional<session::PointedValue> contour{}; // one more besides those of the look
};

// A picture, and all that it was made of.
struct PresentedFrame
{
	std::shared_ptr<const gpu::Image> image; // gpu::kCopyFrom
	FrameRequest wish;
	probe::Probe probe; // as it stands in the picture, hidden sheets included
	std::shared_ptr<const session::CutFrame> cut;
	render::Camera camera;
	render::Frame frame;
	std::optional<render::ValueScale> values;
	struct Pane
	{
		std::shared_ptr<const gpu::Image> image;
		std::size_t sheet;
		render::Camera camera;
		render::Frame frame;
	};
	std::optional<Pane> pane;                    // where one is wished, and its sheet is seen
	bool smooth = false;                         // all samples are in it
	bool empty = false;                          // no sheet cuts anything
	double vector_dt = 0.0;                      // of a step of what is launched from the sheets, 0 without
	std::shared_ptr<const SheetLookups> lookups; // of the cut, once it has been still; or null
	double cut_ms = 0.0;                         // 0 where the cut before was still good
	double draw_ms = 0.0;
	std::uint64_t cuts = 0;     // made so far
	cut::Cutter::Memory memory; // that the cutter keeps
};

// A picture to be kept: all samples, at the wish's size, apart from what is shown.
struct PictureJob
{
	FrameRequest wish;
	bool empty = false; // without the sheets, as the ground of an exposure
	std::function<void(Result<render::Picture>)> take;
};

// Polygons of the sheets, or the faces of their whole cells, to be written.
struct CutJob
{
	FrameRequest wish;
	std::string file;
	std::function<void(Status)> done;
};

// Answered on the render thread's thread, one after the other between pictures.
using Job = std::variant<PictureJob, CutJob>;

// Cuts and draws on a thread of its own what was wished last. The last picture stays until the next is ready, and what
// cannot be done leaves it as it was. Thread safe.
class RenderThread
{
public:
	// wake: called, on the render thread's thread, when there is something new to be had.
	RenderThread(std::shared_ptr<gpu::Device> device, std::function<void()> wake);
	~RenderThread();
	RenderThread(const RenderThread&) = delete;
	RenderThread& operator=(const RenderThread&) = delete;

	void ask(FrameRequest wish); // takes the place of what waits
	void order(Job order);
	// The next wish is for this one; what waits was for the session before.
	void replaceSession(std::unique_ptr<session::Session> session);

	std::shared_ptr<const PresentedFrame> shown() const; // null before the first picture
	std::optional<Error> takeError();                    // why the last wish is not shown
	bool isIdle() const;                                 // nothing waits and nothing is being done
	std::vector<Timeline::Section> sections() const;     // of the last minute or so, for a trace

private:
	// The contours of a cut, and what they were grown for.
	struct Grown
	{
		std::shared_ptr<const session::CutFrame> cut;
		view::ContourSpec options;
		std::optional<session::PointedValue> pointed;
		session::Contours contours;
	};

	void work();
	void answer(const FrameRequest& wish, bool smooth);
	Status show(const FrameRequest& wish, bool smooth);
	void install(std::unique_ptr<session::Session> session);
	template <class Work>
	auto tried(const Work& work) -> decltype(work());
	// Takes the neighbors of cells, where the session has none, once they are built. Waits for them where they are
	// needed.
	Status takeNeighbors(bool needed);
	Status follow(const FrameRequest& wish);
	Status followAll(const FrameRequest& wish);
	Status followLook(const FrameRequest& wish);
	Status followTime(const read::TimeChoice& time);
	Result<double> cutAsWished(); // ms; 0 where the last cut is still good
	Status growAsWished(const FrameRequest& wish);
	void answer(Job& order);
	Result<render::Picture> picture(const PictureJob& order);
	Status writeSlice(const CutJob& order);
	Result<bool> draw(PresentedFrame& shown, bool smooth);
	Status refine(); // what is shown, while nothing else is wished
	void addLookups();
	Status drawPane(PresentedFrame& shown, const render::Scene& scene);
	static const render::SheetDrawing* sheetOfPane(const PresentedFrame& shown, const render::Scene& scene);
	void publish(PresentedFrame shown);
	bool waits() const;
	void keepSections();

	std::shared_ptr<gpu::Device> device_;
	std::function<void()> wake_;

	// Of the render thread's thread.
	std::unique_ptr<session::Session> session_;
	std::optional<session::Painter> painter_;
	std::optional<FrameRequest> followed_; // what session and painter stand at
	std::shared_ptr<const session::CutFrame> cut_;
	std::uint64_t cuts_ = 0;
	bool cut_is_old_ = true;
	NeighborBuilder neighbors_;
	Grown grown_;
	bool only_moved_ = false;
	std::atomic<bool> rough_ = false; // what is shown is to be refined once it has been still
	Pictures pictures_;
	Pictures pane_pictures_;
	std::optional<render::Renderer> pane_renderer_;

	mutable std::mutex mutex_;
	std::condition_variable changed_;
	std::optional<FrameRequest> wish_;
	std::deque<Job> orders_;
	std::unique_ptr<session::Session> next_session_;
	std::shared_ptr<const PresentedFrame> shown_;
	std::optional<Error> error_;
	std::deque<Timeline::Section> sections_;
	bool busy_ = false;
	bool ends_ = false;
	std::thread thread_; // the last to be made
};

// Of what works with all that memory has.
template <class Work>
auto RenderThread::tried(const Work& work) -> decltype(work())
{
	if (!session_)
		return Error{ErrorKind::input, "nothing is shown yet; open a file first"};
	try
	{
		return work();
	}
	catch (const std::bad_alloc&)
	{
		return Error{ErrorKind::out_of_memory, "out of memory; show fewer sheets or a smaller input"};
	}
}

} // namespace vp::app
