#pragma once

#include "gpu/image.h"
#include "picture/painter.h"
#include "session/frame.h"
#include "view/view_spec.h"
#include "viewer/cutting/backdrop.h"
#include "viewer/cutting/gpu_pictures.h"
#include "viewer/cutting/loader.h"
#include "viewer/cutting/neighbor_builder.h"
#include "viewer/cutting/sheet_lookups.h"
#include "viewer/cutting/window_times.h"

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
#include <stop_token>
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

// Asks for a second picture: one sheet of the probe alone, seen straight on.
struct PaneWish
{
	std::size_t sheet = 0;
	PixelSize size{};

	bool operator==(const PaneWish& other) const
	{
		return sheet == other.sheet && size.width == other.size.width && size.height == other.size.height;
	}
};

// Asks for a picture to show or to save.
struct PictureRequest
{
	std::uint64_t number = 0; // rises from request to request
	view::ViewSpec spec;      // its size is the size of the picture
	Moment since{};           // the oldest input that has not been answered by a picture
	std::optional<PaneWish> pane{};
	std::optional<session::PointedValue> contour{}; // one contour more than those of the look
};

// A picture, and everything that it was made from.
struct PresentedFrame
{
	std::shared_ptr<const gpu::Image> image; // gpu::kCopyFrom
	PictureRequest wish;
	probe::Probe probe; // as the picture shows it, with hidden sheets included
	std::shared_ptr<const session::Frame> cut;
	render::Camera camera;
	render::Frame frame;
	std::optional<render::ValueScale> values;
	std::string colormap; // name of the map, also where the settings leave it to the file
	struct Pane
	{
		std::shared_ptr<const gpu::Image> image;
		std::size_t sheet;
		render::Camera camera;
		render::Frame frame;
	};
	std::optional<Pane> pane;                    // if one was requested and its sheet is visible
	bool smooth = false;                         // the picture has all its samples
	std::optional<int> draft;                    // this coarser level was cut; the exact cut follows
	bool empty = false;                          // no sheet cuts anything
	double vector_dt = 0.0;                      // time of a particle's step, 0 without particles
	std::shared_ptr<const SheetLookups> lookups; // values of the cut, once the probe has rested; or null
	double cut_ms = 0.0;                         // 0 if the cut before was reused
	double draw_ms = 0.0;
	std::uint64_t cuts = 0;     // made so far
	int number = 0;             // in traces; with all its samples it has the same one
	cut::Cutter::Memory memory; // of the cutter
};

// Asks for a picture to save, with all samples and in the size of the request. What is shown does not change.
struct PictureJob
{
	PictureRequest wish;
	bool empty = false; // without the sheets, as the background of an exposure
	std::function<void(Result<render::Picture>)> take;
};

// Asks for a file with the polygons of the sheets, or with the faces of their whole cells.
struct CutJob
{
	PictureRequest wish;
	std::string file;
	std::function<void(Status)> done;
};

// A job is answered on the render thread, between two pictures, in the order of the jobs.
using Job = std::variant<PictureJob, CutJob>;

// Cuts and draws the last request on a thread of its own. The last picture stays until the next one is ready, and also
// if a request fails. Thread safe.
class RenderThread
{
public:
	// wake: called on the render thread when something new is ready.
	RenderThread(std::shared_ptr<gpu::Device> device, std::function<void()> wake, WindowTimes& times);
	~RenderThread();
	RenderThread(const RenderThread&) = delete;
	RenderThread& operator=(const RenderThread&) = delete;

	void ask(PictureRequest wish); // replaces a request that waits
	void order(Job order);
	// The next request is for this session. A request that waits was for the session before, and is dropped.
	void replaceSession(std::unique_ptr<session::Session> session);

	std::shared_ptr<const PresentedFrame> shown() const; // null before the first picture
	std::optional<Error> takeError();                    // why the last request failed
	bool isBusy() const;                                 // a request waits or is under way
	bool isIdle() const;                                 // the same of jobs and of samples to come: there is none

private:
	// The contours of a cut, and what they were grown for.
	struct Grown
	{
		std::shared_ptr<const session::Frame> cut;
		view::ContourSpec options;
		std::optional<session::PointedValue> pointed;
		session::Contours contours;
	};

	// A resolution of the data, and what was made of it. The first is the one that was opened. While the probe moves,
	// another is cut in its place if values stay in their file: a coarser one, all of which is in memory.
	struct Level
	{
		std::unique_ptr<session::Session> session;
		int number = 0;        // the level's, if it is a draft
		double start_ms = 0.0; // where its timeline starts on the time axis of the window
		std::optional<picture::Painter> painter;
		std::optional<PictureRequest> followed; // the request that session and painter follow
		std::shared_ptr<const session::Frame> cut;
		std::optional<PictureRequest> cut_for; // the request that the cut answers
		Grown grown;

		void take(std::unique_ptr<session::Session> other, WindowTimes& times);
	};

	void work();
	void answer(const PictureRequest& wish, bool smooth);
	Status show(const PictureRequest& wish, bool smooth);
	Status show(const PictureRequest& wish); // by the level that was chosen
	void install(std::unique_ptr<session::Session> session);
	// Begins to open a coarser level, if there is one that helps.
	void beginDraft();
	// Returns true if a coarser level is to be cut for a wish, until the probe rests.
	bool wantsDraft(const PictureRequest& wish);
	template <class Work>
	auto tried(const Work& work) -> decltype(work());
	// Gives the session the neighbors of cells once they are built. Waits for them only if they are needed.
	Status takeNeighbors(bool needed);
	Status follow(const PictureRequest& wish);
	Status followAll(const PictureRequest& wish);
	Status followLook(const PictureRequest& wish);
	Status followTime(const read::TimeChoice& time);
	// Returns milliseconds; 0 if the last cut was reused. A stop request ends it with ErrorKind::cancelled.
	Result<double> cutAsWished(std::stop_token stop = {});
	// Returns a token by which the next wish ends the exact cut that follows a draft.
	std::stop_token stopByNextWish();
	Status growAsWished(const PictureRequest& wish);
	void answer(Job& order);
	Result<render::Picture> picture(const PictureJob& order);
	Status writeSlice(const CutJob& order);
	Result<bool> draw(PresentedFrame& shown, bool smooth);
	Status refine(); // adds samples to the picture while no request waits
	void addLookups();
	Status drawPane(PresentedFrame& shown, const render::Scene& scene);
	static const render::SheetDrawing* sheetOfPane(const PresentedFrame& shown, const render::Scene& scene);
	void publish(PresentedFrame shown);
	bool waits() const;
	void keepTimes();

	std::shared_ptr<gpu::Device> device_;
	std::function<void()> wake_;
	WindowTimes& times_;

	// Used by the render thread only.
	Level finest_;
	Level draft_; // without a session where there is none, or not yet
	Level* at_ = &finest_;
	Loader draft_loader_;
	Backdrop backdrop_; // the last picture's of the finest level
	std::uint64_t cuts_ = 0;
	int frames_ = 0;                  // begun so far
	NeighborBuilder neighbors_;       // those of the finest level
	std::atomic<bool> rough_ = false; // the picture gets all its samples once the probe has rested
	Pictures pictures_;
	Pictures pane_pictures_;
	std::optional<render::Renderer> pane_renderer_;

	mutable std::mutex mutex_;
	std::condition_variable changed_;
	std::optional<PictureRequest> wish_;
	std::deque<Job> orders_;
	std::unique_ptr<session::Session> next_session_;
	std::shared_ptr<const PresentedFrame> shown_;
	std::optional<Error> error_;
	std::stop_source next_wish_; // ends the cut under way
	bool busy_ = false;
	bool ends_ = false;
	std::thread thread_; // must be the last member
};

// Runs `work`; an allocation failure becomes an error, so the window stays open.
template <class Work>
auto RenderThread::tried(const Work& work) -> decltype(work())
{
	if (!finest_.session)
		return Error{ErrorKind::input, "nothing is shown yet; open a file first"};
	try
	{
		return work();
	}
	catch (const parts::Unreadable& error)
	{
		return Error{ErrorKind::input, error.what()};
	}
	catch (const std::bad_alloc&)
	{
		return Error{ErrorKind::out_of_memory, "out of memory; show fewer sheets or a smaller input"};
	}
}

} // namespace vp::app
