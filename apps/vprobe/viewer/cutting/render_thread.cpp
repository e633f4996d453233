#include "viewer/cutting/render_thread.h"

#include "base/frame_scope.h"
#include "render/passes/targets.h"
#include "view/resolve.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace vp::app
{

namespace
{

// While the hand moves, pictures have one sample a pixel; the others are added once it has been still for so long.
constexpr std::chrono::milliseconds kStill{120};
constexpr std::string_view kFrameSection = "frame";

} // namespace

RenderThread::RenderThread(std::shared_ptr<gpu::Device> device, std::function<void()> wake, WindowTimes& times)
    : device_(std::move(device)), wake_(std::move(wake)), times_(times), thread_(
                                                                             [this]
                                                                             {
	                                                                             nameThreadRow("render");
	                                                                             work();
                                                                             })
{
}

RenderThread::~RenderThread()
{
	{
		const std::lock_guard lock(mutex_);
		ends_ = true;
	}
	changed_.notify_all();
	thread_.join();
}

void RenderThread::ask(PictureRequest wish)
{
	{
		const std::lock_guard lock(mutex_);
		if (wish_)
			wish.since = std::min(wish.since, wish_->since); // its input is answered by this one's picture
		wish_ = std::move(wish);
	}
	changed_.notify_all();
}

void RenderThread::replaceSession(std::unique_ptr<session::Session> session)
{
	const std::lock_guard lock(mutex_);
	next_session_ = std::move(session);
	wish_.reset();
}

std::shared_ptr<const PresentedFrame> RenderThread::shown() const
{
	const std::lock_guard lock(mutex_);
	return shown_;
}

std::optional<Error> RenderThread::takeError()
{
	const std::lock_guard lock(mutex_);
	return std::exchange(error_, std::nullopt);
}

bool RenderThread::isBusy() const
{
	const std::lock_guard lock(mutex_);
	return wish_ || busy_;
}

bool RenderThread::isIdle() const
{
	const std::lock_guard lock(mutex_);
	return !wish_ && orders_.empty() && !busy_ && !rough_;
}

void RenderThread::order(Job order)
{
	{
		const std::lock_guard lock(mutex_);
		orders_.push_back(std::move(order));
	}
	changed_.notify_all();
}

bool RenderThread::waits() const
{
	const std::lock_guard lock(mutex_);
	return wish_ || ends_;
}

void RenderThread::work()
{
	std::unique_lock lock(mutex_);
	const auto woken = [this] { return wish_ || !orders_.empty() || ends_; };
	for (;;)
	{
		const bool still = rough_ ? !changed_.wait_for(lock, kStill, woken) : (changed_.wait(lock, woken), false);
		if (ends_)
			return;
		std::optional<PictureRequest> wish = still ? std::optional(shown_->wish) : std::exchange(wish_, std::nullopt);
		std::optional<Job> order;
		if (!orders_.empty())
		{
			order = std::move(orders_.front());
			orders_.pop_front();
		}
		std::unique_ptr<session::Session> session = std::move(next_session_);
		busy_ = true;
		lock.unlock();
		if (session)
			install(std::move(session));
		if (wish)
			answer(*wish, still);
		if (order)
			answer(*order);
		keepTimes();
		wake_();
		lock.lock();
		busy_ = false;
	}
}

void RenderThread::keepTimes()
{
	if (!session_)
		return;
	std::vector<Timeline::Section> sections = times_.take(*session_->timeline(), session_start_ms_);
	const auto is_frame = [row = threadRow()](const Timeline::Section& section)
	{ return section.row == row && section.name == kFrameSection; };
	const auto frame = std::ranges::find_if(sections, is_frame);
	if (frame == sections.end())
		return;
	// The rest is what came before: reading, jobs, and samples of the picture before.
	const auto is_elsewhere = [frame = *frame](const Timeline::Section& section)
	{
		return section.track != Timeline::Track::gpu &&
		       (section.row != frame.row || section.start_ms < frame.start_ms ||
		        section.start_ms > frame.start_ms + frame.duration_ms);
	};
	std::erase_if(sections, is_elsewhere);
	times_.addFrame(stageTimes(std::move(sections)));
}

void RenderThread::install(std::unique_ptr<session::Session> session)
{
	painter_.reset();
	cut_.reset();
	grown_ = {};
	followed_.reset();
	rough_ = false;
	neighbors_.drop();
	session_ = std::move(session);
	session_start_ms_ = times_.startOf(*session_->timeline());
}

void RenderThread::answer(const PictureRequest& wish, bool smooth)
{
	const Status done = tried([&] { return show(wish, smooth); });
	if (done)
		return;
	const std::lock_guard lock(mutex_);
	error_ = done.error();
}

Status RenderThread::show(const PictureRequest& wish, bool smooth)
{
	if (smooth)
		return refine();
	const FrameScope scope(++frames_, FrameScope::Stop::picture);
	const TimedSection section(session_->timeline(), kFrameSection);
	PresentedFrame shown;
	shown.number = frames_;
	shown.wish = wish;
	if (Status followed = follow(wish); !followed)
		return followed;
	shown.probe = view::makeProbe(wish.spec.probe, session_->blocks().bounds());
	Result<double> cut_ms = cutAsWished();
	if (!cut_ms)
		return cut_ms.error();
	shown.cut_ms = *cut_ms;
	if (Status grown = growAsWished(wish); !grown)
		return grown;
	shown.cut = cut_;
	shown.cuts = cuts_;
	shown.empty = std::ranges::all_of(cut_->slice.sheets, session::isEmpty);
	shown.memory = session_->cutter().memory();
	shown.vector_dt = session_->view().launch ? session_->launch().dt : 0.0;
	if (const auto before = this->shown(); before && before->cut == cut_)
		shown.lookups = before->lookups;
	Result<bool> drawn = draw(shown, false);
	if (!drawn)
		return drawn.error();
	publish(std::move(shown));
	rough_ = true;
	// The picture is there; now comes what makes a moved cut fast.
	if (!grid::hasNeighbors(session_->blocks()))
		neighbors_.begin(session_->blocks());
	return Nothing{};
}

Status RenderThread::refine()
{
	rough_ = false;
	const PictureRequest wish = shown()->wish;
	// An order may have led session and painter elsewhere.
	if (!followed_ || !(followed_->spec == wish.spec) || grown_.cut != cut_ || !(grown_.pointed == wish.contour))
		return show(wish, false);
	addLookups();
	PresentedFrame shown = *this->shown();
	if (shown.smooth || waits())
		return Nothing{};
	const FrameScope scope(shown.number, FrameScope::Stop::picture);
	Result<bool> drawn = draw(shown, true);
	if (!drawn)
		return drawn.error();
	if (*drawn)
		publish(std::move(shown));
	return Nothing{};
}

void RenderThread::addLookups()
{
	PresentedFrame shown = *this->shown();
	if (shown.lookups)
		return;
	const bool by_generation = shown.wish.spec.look.color_by == view::ColorBy::generation;
	shown.lookups = std::make_shared<const SheetLookups>(*session_, shown.cut, by_generation);
	publish(std::move(shown));
	wake_();
}

// False where a new wish came meanwhile.
Result<bool> RenderThread::draw(PresentedFrame& shown, bool smooth)
{
	const Moment start = std::chrono::steady_clock::now();
	const TimedSection section(session_->timeline(), "render");
	FrameScope::comesTo(FrameScope::Stop::picture, session_->timeline());
	Result<render::Scene> scene = painter_->sceneOf(shown.cut->slice, shown.cut->sheets, grown_.contours);
	if (!scene)
		return scene.error();
	shown.smooth = smooth || scene->look.samples == 1;
	if (!smooth)
		scene->look.samples = 1;
	Result<std::shared_ptr<gpu::Image>> image = pictures_.take(*device_, {scene->look.width, scene->look.height});
	if (!image)
		return image.error();
	Result<bool> drawn = painter_->renderer().drawInto(
	    *scene, **image, [&] { return !smooth || !waits(); }, session_->timeline());
	if (!drawn || !*drawn)
		return drawn;
	shown.image = *image;
	shown.camera = scene->camera;
	shown.frame = render::pictureFrame(*scene);
	shown.values = scene->values;
	shown.colormap = scene->look.colors.name;
	if (Status pane = drawPane(shown, *scene); !pane)
		return pane.error();
	shown.draw_ms = millisecondsSince(start);
	return true;
}

void RenderThread::publish(PresentedFrame shown)
{
	auto made = std::make_shared<const PresentedFrame>(std::move(shown));
	const std::lock_guard lock(mutex_);
	shown_ = std::move(made);
	error_.reset();
}

} // namespace vp::app
